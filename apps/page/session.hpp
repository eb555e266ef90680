#pragma once
/// What the page in the browser does with the meshes dropped on it: read, match, show, carry, merge. The same steps as
/// of the command line, in the same words, on bytes instead of files (docs/design/021-page.md).

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <quadmatch/io/file.hpp>
#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/match/matcher.hpp>
#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/use/merge.hpp>

#include "../quadmatch/match_arguments.hpp"
#include "../quadmatch/match_report.hpp"

namespace quadmatch::page {

/// Source and target of a match, which are base and one edit of a merge; the other edit.
enum class Slot : std::uint8_t { Source, Target, Other };

/// Who is told how far the work is.
struct Listener {
  std::function<void(std::string_view)> stage = [](std::string_view) {};
  std::function<void(std::size_t done, std::size_t most)> progress = [](std::size_t, std::size_t) {};
};

/// A file to save, and what is said of it.
struct Product {
  std::string bytes;
  std::string summary;
};

/// One after the other, and each as often as one likes: read, choose, match; then take what is wanted.
class Session {
 public:
  explicit Session(Listener listener) : listener_(std::move(listener)) {}

  /// Take a mesh in. @param name  of the file: tells its format, and stands in messages and in the match file.
  /// @return      what the command line would warn of, a sentence each.
  /// @par Errors  those of parse_mesh.
  [[nodiscard]] Expected<std::vector<std::string>> read(Slot slot, const FileBytes& bytes, const std::string& name);

  /// Set an option by its name on the command line without the dashes: algorithm, orientation, positions (true, false),
  /// min-region, min-confidence, time-limit, prefer.
  /// @par Errors  BadArgument.
  [[nodiscard]] Expected<void> choose(std::string_view name, const std::string& value);

  /// Match source and target, and check the match.
  /// @return      the report of it for the viewer.
  /// @par Errors  BadArgument where a mesh is missing.
  [[nodiscard]] Expected<PackedReport> match();

  /// The bytes that `quadmatch match SOURCE TARGET -o FILE` writes. @par Errors  BadArgument before a match.
  [[nodiscard]] Expected<std::string> match_file() const;

  /// The target with the source's data, as of `quadmatch transfer`. @param name  tells the format.
  /// @par Errors  BadArgument before a match, or where nothing can be carried; those of transfer.
  [[nodiscard]] Expected<Product> transferred(const std::string& name) const;

  /// Both edits brought together, as of `quadmatch merge SOURCE TARGET OTHER`. @param name  tells the format.
  /// @par Errors  BadArgument where a mesh is missing; those of merge.
  [[nodiscard]] Expected<Product> merged(const std::string& name) const;

 private:
  [[nodiscard]] const std::optional<MeshFile>& file(Slot slot) const { return files_[static_cast<std::size_t>(slot)]; }
  [[nodiscard]] MatchOptions options() const;

  Listener listener_;
  std::array<std::optional<MeshFile>, 3> files_;
  cli::MatchingArguments arguments_;
  Side prefer_ = Side::Ours;
  std::optional<MatchResult> result_;
};

}  // namespace quadmatch::page
