#include "program.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <doctest/doctest.h>
#include <quadmatch/io/write_mesh.hpp>

namespace quadmatch::test {
namespace {

namespace fs = std::filesystem;

fs::path fresh_folder() {
  std::string name = (fs::temp_directory_path() / "quadmatch-test-XXXXXX").string();
  REQUIRE(::mkdtemp(name.data()) != nullptr);
  return name;
}

void write_file(const fs::path& path, std::string_view bytes) {
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  REQUIRE(file.good());
}

std::string read_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

/// In the child: become the program, with its three streams in `streams`. Only what is safe after fork.
[[noreturn]] void become_program(const char* program, const char* folder, const fs::path& streams,
                                 std::vector<char*>& arguments) {
  const std::string input = (streams / "in").string();
  const std::string output = (streams / "out").string();
  const std::string errors = (streams / "err").string();
  ::dup2(::open(input.c_str(), O_RDONLY), STDIN_FILENO);
  ::dup2(::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  ::dup2(::open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
  if (::chdir(folder) == 0) ::execv(program, arguments.data());
  std::_Exit(127);
}

Outcome run_program(const char* program, const fs::path& folder, const std::vector<std::string>& arguments,
                    std::string_view input) {
  const fs::path streams = fresh_folder();
  write_file(streams / "in", input);
  std::vector<std::string> words{fs::path(program).filename()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const ::pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) become_program(program, folder.c_str(), streams, pointers);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  Outcome outcome;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = read_file(streams / "out");
  outcome.err = read_file(streams / "err");
  fs::remove_all(streams);
  return outcome;
}

}  // namespace

Folder::Folder() : folder_(fresh_folder()) {}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Folder::write(std::string_view name, std::string_view bytes) const { write_file(path(name), bytes); }

void Folder::write(std::string_view name, const PolygonSoup& soup) const { write(name, obj_of(soup)); }

std::string Folder::read(std::string_view name) const {
  REQUIRE(has(name));
  return read_file(path(name));
}

std::vector<std::string> Folder::names() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Outcome Folder::run(const std::vector<std::string>& arguments, std::string_view input) const {
  return run_program(QUADMATCH_PROGRAM, folder_, arguments, input);
}

Outcome Folder::run_git(const std::vector<std::string>& arguments) const {
  ::setenv("GIT_CONFIG_GLOBAL", "/dev/null", 1);
  ::setenv("GIT_CONFIG_NOSYSTEM", "1", 1);
  ::setenv("GIT_PAGER", "cat", 1);
  return run_program(QUADMATCH_GIT, folder_, arguments, {});
}

Outcome Folder::edit_mesh(const std::vector<std::string>& arguments) const {
  return run_program(QUADMATCH_EDIT_MESH, folder_, arguments, {});
}

Outcome Folder::make_shape(const std::vector<std::string>& arguments) const {
  return run_program(QUADMATCH_MAKE_SHAPE, folder_, arguments, {});
}

Outcome Folder::shell(const std::string& script) const {
  const std::string settings =
      std::string("export QUADMATCH='") + QUADMATCH_PROGRAM +
      "' HOME=/nonexistent GIT_CONFIG_NOSYSTEM=1 GIT_CONFIG_GLOBAL=/dev/null\n"
      "export GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b\n";
  return run_program("/bin/sh", folder_, {"-c", settings + script}, {});
}

std::string obj_of(const PolygonSoup& soup) {
  Expected<Mesh> mesh = Mesh::build(soup);
  REQUIRE(mesh.has_value());
  return format_mesh(MeshFile{*std::move(mesh)}, Format::Obj);
}

void check_refused(const Folder& folder, const std::vector<std::string>& begin, const std::vector<Trouble>& troubles) {
  for (const Trouble& trouble : troubles) {
    std::vector<std::string> arguments = begin;
    arguments.insert(arguments.end(), trouble.arguments.begin(), trouble.arguments.end());
    const Outcome outcome = folder.run(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err == "quadmatch: " + trouble.complaint + "\n");
  }
}

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

std::size_t line_count(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace quadmatch::test
