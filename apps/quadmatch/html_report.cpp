#include "html_report.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "console.hpp"
#include "inputs.hpp"

namespace quadmatch::cli {

void add_report_option(CLI::App& verb, std::string& page) {
  verb.add_option("--report", page,
                  "HTML file to write: both meshes to turn and point at, the growth wave by wave, figures and a list "
                  "of what differs; opens from disk and loads nothing")
      ->type_name("FILE");
}

bool report_fits(const std::string& page, const std::vector<std::string>& inputs,
                 const std::vector<std::string>& outputs) {
  if (page.empty()) return true;
  if (page == "-") {
    complain("--report needs the name of a file, such as report.html; - is for standard output, which has the figures");
    return false;
  }
  for (const std::string& output : outputs) {
    if (output.empty() || output == "-" || !same_file(page, output)) continue;
    complain(
        fmt::format("{}: another option and --report name the same file; choose another name for one of them", page));
    return false;
  }
  return paths_fit(inputs, page, "--report");
}

std::string report_title(const std::string& source, const std::string& target) {
  const auto name = [](const std::string& path) {
    return path == "-" ? display_name(path) : std::filesystem::path(path).filename().string();
  };
  return fmt::format("{} and {}", name(source), name(target));
}

}  // namespace quadmatch::cli
