#pragma once
/// --report FILE: the page a verb writes for whoever wants to look (report/report.hpp).

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <quadmatch/report/report.hpp>

namespace quadmatch::cli {

/// Declare the option; `page` stays empty where it is not given.
void add_report_option(CLI::App& verb, std::string& page);

/// May the page be written, if one was asked for? Complains where it is no file, an input, or another output.
/// @param outputs  other files that are written; empty names and `-` are passed over.
[[nodiscard]] bool report_fits(const std::string& page, const std::vector<std::string>& inputs,
                               const std::vector<std::string>& outputs);

/// "bear.obj and bear_posed.obj": the names without their folders.
[[nodiscard]] std::string report_title(const std::string& source, const std::string& target);

}  // namespace quadmatch::cli
