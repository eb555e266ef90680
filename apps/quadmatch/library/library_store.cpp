// A mesh of 128 values takes about 128 * 19 bytes in `places` (7 to 9 of payload, the rest is SQLite's order and the
// room a tree leaves), 512 in `meshes`, and its path twice: see docs/design/026-find.md.

#include "library_store.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <system_error>
#include <utility>

#include <fmt/format.h>

namespace quadmatch::cli {
namespace {

constexpr std::int64_t kApplication = 0x514d4c42;  // "QMLB", so that `file` and we know our own

constexpr const char* kTables = R"(
CREATE TABLE about (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE meshes (number INTEGER PRIMARY KEY, path TEXT NOT NULL UNIQUE, size INTEGER NOT NULL,
                     modified INTEGER NOT NULL, error TEXT, vertices INTEGER NOT NULL, faces INTEGER NOT NULL,
                     elements INTEGER NOT NULL, signature BLOB NOT NULL);
CREATE INDEX meshes_by_size ON meshes (faces) WHERE error IS NULL;
CREATE TABLE places (value INTEGER NOT NULL, mesh INTEGER NOT NULL, PRIMARY KEY (value, mesh)) WITHOUT ROWID;
)";

/// As SQLite keeps it in four bytes; its numbers have a sign.
std::int64_t place_of(std::uint32_t value) { return static_cast<std::int32_t>(value); }

/// Values as bytes, the lowest byte first on every machine.
std::string bytes_of(const std::vector<std::uint32_t>& values) {
  std::string bytes;
  bytes.reserve(values.size() * 4);
  for (const std::uint32_t value : values) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xffU);
  }
  return bytes;
}

std::vector<std::uint32_t> values_of(const std::string& bytes) {
  std::vector<std::uint32_t> values(bytes.size() / 4);
  for (std::size_t k = 0; k < values.size() * 4; ++k) {
    values[k / 4] |= std::uint32_t{static_cast<unsigned char>(bytes[k])} << (k % 4 * 8);
  }
  return values;
}

}  // namespace

Expected<std::unique_ptr<LibraryStore>> LibraryStore::open(const std::string& path, const std::string& folder) {
  Expected<std::unique_ptr<Database>> database = Database::open(path, Database::Access::Write);
  if (!database) return Unexpected(database.error());
  std::unique_ptr<LibraryStore> store(new LibraryStore);
  store->database_ = *std::move(database);
  if (Expected<void> ready = store->make(folder); !ready) return Unexpected(ready.error());
  if (Expected<void> ready = store->prepare(); !ready) return Unexpected(ready.error());
  if (store->folder_ == folder) return store;
  return Unexpected(
      Error{ErrorCode::CannotWrite,
            fmt::format("this is the library of {}, not of {}; choose another file", store->folder_, folder), path});
}

Expected<std::unique_ptr<LibraryStore>> LibraryStore::open_to_read(const std::string& path) {
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown)) {
    return Unexpected(
        Error{ErrorCode::CannotRead, "there is no such library; make it with quadmatch index FOLDER -o FILE", path});
  }
  Expected<std::unique_ptr<Database>> database = Database::open(path, Database::Access::Read);
  if (!database) return Unexpected(database.error());
  std::unique_ptr<LibraryStore> store(new LibraryStore);
  store->database_ = *std::move(database);
  if (Expected<void> fits = store->check(); !fits) return Unexpected(fits.error());
  // Pages are read where they lie in memory: a query touches more of them than SQLite keeps by itself.
  if (Expected<void> mapped = store->database_->run("PRAGMA mmap_size = 1099511627776"); !mapped) {
    return Unexpected(mapped.error());
  }
  if (Expected<void> ready = store->prepare(); !ready) return Unexpected(ready.error());
  return store;
}

Expected<void> LibraryStore::make(const std::string& folder) {
  // At once, so that of two processes that begin together one finds the tables of the other.
  if (Expected<void> begun = begin(); !begun) return begun;
  const Expected<std::int64_t> tables = database_->number("SELECT count(*) FROM sqlite_master");
  if (!tables) return Unexpected(tables.error());
  if (*tables > 0) {
    if (Expected<void> fits = check(); !fits) return fits;
    return commit();
  }
  if (Expected<void> made = database_->run(kTables); !made) return made;
  if (Expected<void> signed_by =
          database_->run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", kApplication, kVersion));
      !signed_by) {
    return signed_by;
  }
  Expected<Statement> about = database_->prepare("INSERT INTO about VALUES ('folder', ?), ('program', ?)");
  if (!about) return Unexpected(about.error());
  about->bind(folder);
  about->bind(std::string_view("quadmatch " QUADMATCH_VERSION));
  if (Expected<void> kept = about->run(); !kept) return kept;
  return commit();
}

Expected<void> LibraryStore::check() {
  const Expected<std::int64_t> application = database_->number("PRAGMA application_id");
  if (!application) return Unexpected(application.error());
  const Expected<std::int64_t> version = database_->number("PRAGMA user_version");
  if (!version) return Unexpected(version.error());
  if (*application == kApplication && *version == kVersion) return {};
  return Unexpected(
      Error{ErrorCode::CannotRead,
            *application == kApplication
                ? fmt::format("this library is of version {} and this program works with version {}; index the folder "
                              "anew, into another file",
                              *version, kVersion)
                : "this database is not one of index; choose another file",
            database_->path()});
}

Expected<void> LibraryStore::prepare() {
  const std::pair<std::unique_ptr<Statement>*, const char*> statements[] = {
      {&find_, "SELECT number, size, modified, error, vertices, faces, elements FROM meshes WHERE path = ?"},
      {&mesh_, "SELECT path, size, modified, error, vertices, faces, elements, signature FROM meshes WHERE number = ?"},
      {&insert_mesh_,
       "INSERT INTO meshes (number, path, size, modified, error, vertices, faces, elements, signature) VALUES (?, ?, "
       "?, ?, ?, ?, ?, ?, ?)"},
      {&insert_place_, "INSERT OR IGNORE INTO places (value, mesh) VALUES (?, ?)"},
      {&remove_mesh_, "DELETE FROM meshes WHERE number = ?"},
      {&remove_place_, "DELETE FROM places WHERE value = ? AND mesh = ?"},
      {&places_, "SELECT mesh FROM places WHERE value = ? ORDER BY mesh LIMIT ?"}};
  for (const auto& [kept, sql] : statements) {
    Expected<Statement> statement = database_->prepare(sql);
    if (!statement) return Unexpected(statement.error());
    *kept = std::make_unique<Statement>(*std::move(statement));
  }
  Expected<Statement> folder = database_->prepare("SELECT value FROM about WHERE key = 'folder'");
  if (!folder) return Unexpected(folder.error());
  const Expected<bool> row = folder->step();
  if (!row) return Unexpected(row.error());
  if (*row) folder->take(folder_);
  return {};
}

Expected<std::int64_t> LibraryStore::mesh_count() {
  return database_->number("SELECT count(*) FROM meshes WHERE error IS NULL");
}

Expected<std::int64_t> LibraryStore::broken_count() {
  return database_->number("SELECT count(*) FROM meshes WHERE error IS NOT NULL");
}

Expected<std::optional<LibraryMesh>> LibraryStore::find(const std::string& path) {
  find_->bind(path);
  const Expected<bool> row = find_->step();
  if (!row) return Unexpected(row.error());
  if (!*row) return std::optional<LibraryMesh>();
  LibraryMesh mesh;
  mesh.file.path = path;
  find_->take(mesh.number);
  find_->take(mesh.file.size);
  find_->take(mesh.file.modified);
  find_->take(mesh.error);
  find_->take(mesh.vertices);
  find_->take(mesh.faces);
  find_->take(mesh.signature.elements);
  find_->reset();
  return std::optional(std::move(mesh));
}

Expected<LibraryMesh> LibraryStore::mesh(std::int64_t number) {
  mesh_->bind(number);
  const Expected<bool> row = mesh_->step();
  if (!row) return Unexpected(row.error());
  LibraryMesh mesh{.number = number};
  if (!*row) return mesh;  // forgotten since it was found
  std::string bytes;
  mesh_->take(mesh.file.path);
  mesh_->take(mesh.file.size);
  mesh_->take(mesh.file.modified);
  mesh_->take(mesh.error);
  mesh_->take(mesh.vertices);
  mesh_->take(mesh.faces);
  mesh_->take(mesh.signature.elements);
  mesh_->take(bytes);
  mesh_->reset();
  mesh.signature.values = values_of(bytes);
  return mesh;
}

Expected<std::vector<std::string>> LibraryStore::paths() {
  Expected<Statement> statement = database_->prepare("SELECT path FROM meshes ORDER BY path");
  if (!statement) return Unexpected(statement.error());
  std::vector<std::string> paths;
  while (true) {
    const Expected<bool> row = statement->step();
    if (!row) return Unexpected(row.error());
    if (!*row) return paths;
    statement->take(paths.emplace_back());
  }
}

Expected<void> LibraryStore::remove_places(std::int64_t number) {
  const Expected<LibraryMesh> before = mesh(number);
  if (!before) return Unexpected(before.error());
  for (const std::uint32_t value : before->signature.values) {
    remove_place_->bind(place_of(value));
    remove_place_->bind(number);
    if (Expected<void> removed = remove_place_->run(); !removed) return removed;
  }
  return {};
}

Expected<void> LibraryStore::remove(const std::string& path) {
  const Expected<std::optional<LibraryMesh>> before = find(path);
  if (!before) return Unexpected(before.error());
  if (!*before) return {};
  if (Expected<void> removed = remove_places((*before)->number); !removed) return removed;
  remove_mesh_->bind((*before)->number);
  return remove_mesh_->run();
}

Expected<void> LibraryStore::record(const LibraryMesh& mesh) {
  const Expected<std::optional<LibraryMesh>> before = find(mesh.file.path);
  if (!before) return Unexpected(before.error());
  if (Expected<void> removed = remove(mesh.file.path); !removed) return removed;
  const Expected<std::int64_t> last = database_->number("SELECT max(number) FROM meshes");
  if (!last) return Unexpected(last.error());
  const std::int64_t number = *before ? (*before)->number : *last + 1;
  insert_mesh_->bind(number);
  insert_mesh_->bind(mesh.file.path);
  insert_mesh_->bind(mesh.file.size);
  insert_mesh_->bind(mesh.file.modified);
  insert_mesh_->bind(mesh.error);
  insert_mesh_->bind(mesh.vertices);
  insert_mesh_->bind(mesh.faces);
  insert_mesh_->bind(mesh.signature.elements);
  insert_mesh_->bind_bytes(bytes_of(mesh.signature.values));
  if (Expected<void> kept = insert_mesh_->run(); !kept) return kept;
  for (const std::uint32_t value : mesh.signature.values) {
    insert_place_->bind(place_of(value));
    insert_place_->bind(number);
    if (Expected<void> kept = insert_place_->run(); !kept) return kept;
  }
  return {};
}

Expected<void> LibraryStore::meshes_with(std::uint32_t value, std::uint32_t most, std::vector<std::int64_t>& found) {
  found.clear();
  places_->bind(place_of(value));
  places_->bind(most);
  while (true) {
    const Expected<bool> row = places_->step();
    if (!row) return Unexpected(row.error());
    if (!*row) return {};
    places_->take(found.emplace_back());
  }
}

Expected<std::vector<std::int64_t>> LibraryStore::meshes_of_size(std::uint32_t faces, std::uint32_t most) {
  std::vector<std::int64_t> found;
  for (const char* const sql :
       {"SELECT number FROM meshes WHERE error IS NULL AND faces >= ? ORDER BY faces, number LIMIT ?",
        "SELECT number FROM meshes WHERE error IS NULL AND faces < ? ORDER BY faces DESC, number LIMIT ?"}) {
    Expected<Statement> statement = database_->prepare(sql);
    if (!statement) return Unexpected(statement.error());
    statement->bind(faces);
    statement->bind(most);
    while (true) {
      const Expected<bool> row = statement->step();
      if (!row) return Unexpected(row.error());
      if (!*row) break;
      statement->take(found.emplace_back());
    }
  }
  return found;
}

}  // namespace quadmatch::cli
