// quadmatch generate FOLDER: manual pages and completions, for those who pack the program. Not named in its help.

#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <quadmatch/io/file.hpp>

#include "command.hpp"
#include "console.hpp"
#include "generate/manual.hpp"

namespace quadmatch::cli {
namespace {

struct GenerateArguments {
  const CLI::App* program = nullptr;
  std::string folder;
};

/// Where a file lies under /usr/share, and what is in it.
using SharedFile = std::pair<std::string, std::string>;

std::vector<SharedFile> shared_files(const CLI::App& program) {
  std::vector<SharedFile> files{{"man/man1/quadmatch.1", program_manual(program)},
                                {"bash-completion/completions/quadmatch", bash_completion(program)},
                                {"zsh/vendor-completions/_quadmatch", zsh_completion(program)},
                                {"fish/vendor_completions.d/quadmatch.fish", fish_completion(program)}};
  for (const CLI::App* verb : shown_verbs(program)) {
    files.emplace_back("man/man1/quadmatch-" + verb->get_name() + ".1", verb_manual(program, *verb));
  }
  return files;
}

int run_generate(const GenerateArguments& arguments) {
  for (const auto& [name, text] : shared_files(*arguments.program)) {
    const std::filesystem::path path = std::filesystem::path(arguments.folder) / name;
    std::error_code failed;  // then the file cannot be written either, which is complained about
    std::filesystem::create_directories(path.parent_path(), failed);
    if (Expected<void> written = replace_file(path.string(), text); !written) return complain(written.error());
  }
  return kSame;
}

}  // namespace

void add_generate_command(CLI::App& program, Action& chosen) {
  GenerateArguments* arguments = nullptr;
  CLI::App* const verb = add_verb(program, "generate", "Write manual pages and completions as a package installs them",
                                  arguments, run_generate, chosen);
  arguments->program = &program;
  verb->group("");
  verb->add_option("FOLDER", arguments->folder, "Folder to write into, as it were /usr/share")->required();
}

}  // namespace quadmatch::cli
