#pragma once
/// A library: a SQLite database of the signatures of a folder's meshes.
///
/// Table `meshes` has a row for each file, `places` one for each value of each signature, so that those meshes are
/// found at once that have a value.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <quadmatch/analysis/signature.hpp>
#include <quadmatch/mesh/expected.hpp>

#include "batch/sqlite.hpp"
#include "mesh_files.hpp"

namespace quadmatch::cli {

/// What is kept of a mesh file.
struct LibraryMesh {
  std::int64_t number = 0;  ///< in the library, kept for as long as the file stays
  FoundFile file = {};
  std::optional<std::string> error = {};  ///< why it cannot be read, one sentence; then there is nothing below
  std::uint32_t vertices = 0, faces = 0;
  Signature signature = {};
};

class LibraryStore {
 public:
  /// The layout of the tables, and what elements are made of: another one cannot be compared.
  static constexpr std::int64_t kVersion = 1;
  /// Values kept of a mesh.
  static constexpr std::uint32_t kValues = 128;

  /// Open a library to fill it; make it where there is none.
  /// @param folder   that it is of, as a whole path.
  /// @par Errors     CannotWrite: it is of another folder, version or program, another process writes it, or the
  ///                 outside world does not allow it.
  [[nodiscard]] static Expected<std::unique_ptr<LibraryStore>> open(const std::string& path, const std::string& folder);
  /// Open a library to ask it. @par Errors  CannotRead, CannotWrite: likewise.
  [[nodiscard]] static Expected<std::unique_ptr<LibraryStore>> open_to_read(const std::string& path);

  /// What it is of: a whole path.
  [[nodiscard]] const std::string& folder() const { return folder_; }
  /// Meshes that could be read, and files that could not.
  [[nodiscard]] Expected<std::int64_t> mesh_count();
  [[nodiscard]] Expected<std::int64_t> broken_count();

  /// What is kept of a file, but for its signature; nothing where it is not in the library.
  [[nodiscard]] Expected<std::optional<LibraryMesh>> find(const std::string& path);
  /// Of the numbered mesh, all.
  [[nodiscard]] Expected<LibraryMesh> mesh(std::int64_t number);
  /// The paths of all files, ascending.
  [[nodiscard]] Expected<std::vector<std::string>> paths();

  /// Between these, changes are made as one: all of them outlive the process, or none.
  [[nodiscard]] Expected<void> begin() { return database_->run("BEGIN IMMEDIATE"); }
  /// Between this and `commit` the library does not change for this process, and no other can change it.
  [[nodiscard]] Expected<void> begin_reading() { return database_->run("BEGIN"); }
  [[nodiscard]] Expected<void> commit() { return database_->run("COMMIT"); }
  /// Keep a mesh, in the place of what was kept of its file.
  [[nodiscard]] Expected<void> record(const LibraryMesh& mesh);
  /// Forget a file.
  [[nodiscard]] Expected<void> remove(const std::string& path);

  /// The meshes that have a value, ascending; the first `most` of them.
  [[nodiscard]] Expected<void> meshes_with(std::uint32_t value, std::uint32_t most, std::vector<std::int64_t>& found);
  /// The meshes nearest in size, `most` from `faces` up and as many below.
  [[nodiscard]] Expected<std::vector<std::int64_t>> meshes_of_size(std::uint32_t faces, std::uint32_t most);

 private:
  LibraryStore() = default;
  [[nodiscard]] Expected<void> make(const std::string& folder);
  [[nodiscard]] Expected<void> check();
  [[nodiscard]] Expected<void> prepare();
  [[nodiscard]] Expected<void> remove_places(std::int64_t number);

  std::unique_ptr<Database> database_;
  std::string folder_;
  std::unique_ptr<Statement> find_, mesh_, insert_mesh_, insert_place_, remove_mesh_, remove_place_, places_;
};

}  // namespace quadmatch::cli
