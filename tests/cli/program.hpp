#pragma once
/// The real program, run in an empty folder; all that it prints and leaves behind can be looked at.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::test {

struct Outcome {
  int status = -1;  ///< exit status; 128 + the signal where one ended the program
  std::string out;
  std::string err;
};

/// A fresh folder, removed with all that is in it.
class Folder {
 public:
  Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder();

  [[nodiscard]] std::filesystem::path path(std::string_view name) const { return folder_ / name; }
  void write(std::string_view name, std::string_view bytes) const;
  void write(std::string_view name, const PolygonSoup& soup) const;
  [[nodiscard]] std::string read(std::string_view name) const;
  [[nodiscard]] bool has(std::string_view name) const { return std::filesystem::exists(path(name)); }
  /// Names of all files and folders in it, in order.
  [[nodiscard]] std::vector<std::string> names() const;

  /// Run quadmatch here.
  Outcome run(const std::vector<std::string>& arguments, std::string_view input = {}) const;
  /// Run git here, with no settings but its own.
  Outcome run_git(const std::vector<std::string>& arguments) const;
  /// Run edit_mesh here.
  Outcome edit_mesh(const std::vector<std::string>& arguments) const;
  /// Run make_shape here.
  Outcome make_shape(const std::vector<std::string>& arguments) const;
  /// Run a script here, with quadmatch as `$QUADMATCH`; nothing of the user's settings reaches git.
  Outcome shell(const std::string& script) const;

 private:
  std::filesystem::path folder_;
};

/// Arguments that make no sense, and what is said of them.
struct Trouble {
  std::vector<std::string> arguments;
  std::string complaint;
};
/// Each is refused with status 2 and its one line, and nothing on standard output.
/// @param begin  arguments before those of each trouble
void check_refused(const Folder& folder, const std::vector<std::string>& begin, const std::vector<Trouble>& troubles);

/// A mesh as OBJ text.
[[nodiscard]] std::string obj_of(const PolygonSoup& soup);

[[nodiscard]] bool contains(std::string_view text, std::string_view part);
[[nodiscard]] std::size_t line_count(std::string_view text);

}  // namespace quadmatch::test
