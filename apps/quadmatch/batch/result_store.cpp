// The database is in WAL mode while a run goes on: a row that is committed outlives a killed process without a sync
// for each, and others may read. In the end the log is taken in, so that one file remains.

#include "result_store.hpp"

#include <cerrno>
#include <filesystem>
#include <map>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>

#include <quadmatch/io/file.hpp>

namespace quadmatch::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kApplication = 0x514d4254;  // "QMBT", so that `file` and we know our own
constexpr const char* kDatabase = "results.sqlite";
constexpr const char* kNewDatabase = "results.sqlite.new";

template <class Value>
constexpr const char* sql_type() {
  if constexpr (std::is_same_v<Value, std::string>) return "TEXT";
  if constexpr (std::is_same_v<Value, double>) return "REAL";
  return "INTEGER";
}

/// "job INTEGER PRIMARY KEY, line INTEGER NOT NULL, ..."
std::string column_definitions() {
  std::string sql;
  const auto add = [&sql]<class Value>(const char* name, const Value&) {
    if (!sql.empty()) sql += ", ";
    if constexpr (requires(Value value) { value.has_value(); }) {
      sql += fmt::format("{} {}", name, sql_type<typename Value::value_type>());
    } else {
      const bool key = std::string_view(name) == "job";
      sql += fmt::format("{} {} {}", name, sql_type<Value>(), key ? "PRIMARY KEY" : "NOT NULL");
    }
  };
  const PairRow row;
  visit_columns(row, add);
  return sql;
}

/// "job, line, ...", or as many question marks.
std::string column_list(bool marks) {
  std::string sql;
  const PairRow row;
  visit_columns(
      row, [&](const char* name, const auto&) { sql += (sql.empty() ? "" : ", ") + std::string(marks ? "?" : name); });
  return sql;
}

void take_row(Statement& statement, PairRow& row) {
  visit_columns(row, [&statement](const char*, auto& value) { statement.take(value); });
}

Expected<void> make_folder(const std::string& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (!failed && fs::is_directory(folder, failed)) return {};
  const std::string why = failed ? failed.message() : "it is a file";
  return Unexpected(Error{ErrorCode::CannotWrite,
                          fmt::format("cannot be a folder of results: {}; choose another name", why), folder});
}

}  // namespace

std::string ResultStore::in_folder(const char* name) const { return (fs::path(folder_) / name).string(); }

Expected<std::unique_ptr<ResultStore>> ResultStore::open(const std::string& folder) {
  if (Expected<void> made = make_folder(folder); !made) return Unexpected(made.error());
  return open_as(folder, kDatabase);
}

Expected<std::unique_ptr<ResultStore>> ResultStore::open_existing(const std::string& folder) {
  std::error_code missing;
  if (fs::exists(fs::path(folder) / kDatabase, missing)) return open_as(folder, kDatabase);
  return Unexpected(Error{ErrorCode::CannotRead,
                          "there are no results here (no results.sqlite); name the folder that batch wrote", folder});
}

Expected<std::unique_ptr<ResultStore>> ResultStore::open_anew(const std::string& folder) {
  if (Expected<void> made = make_folder(folder); !made) return Unexpected(made.error());
  Expected<std::unique_ptr<ResultStore>> store = open_as(folder, kNewDatabase);
  // What a run that was killed left behind.
  if (store) {
    if (Expected<void> emptied = (*store)->database_->run("DELETE FROM pairs; DELETE FROM about"); !emptied) {
      return Unexpected(emptied.error());
    }
  }
  return store;
}

Expected<std::unique_ptr<ResultStore>> ResultStore::open_as(const std::string& folder, const char* name) {
  Expected<FolderLock> lock = FolderLock::take(folder);
  if (!lock) return Unexpected(lock.error());
  std::unique_ptr<ResultStore> store(new ResultStore(folder, *std::move(lock)));
  Expected<std::unique_ptr<Database>> database = Database::open(store->in_folder(name), Database::Access::Write);
  if (!database) return Unexpected(database.error());
  store->database_ = *std::move(database);
  if (Expected<void> ready = store->prepare(); !ready) return Unexpected(ready.error());
  return store;
}

Expected<void> ResultStore::check_version(std::int64_t version) {
  if (version == kVersion) return {};
  const Expected<std::int64_t> application = database_->number("PRAGMA application_id");
  if (!application) return Unexpected(application.error());
  return Unexpected(Error{
      ErrorCode::CannotWrite,
      *application == kApplication
          ? fmt::format("these results are of version {} and this program writes version {}; use the program that made "
                        "them, or choose another folder",
                        version, kVersion)
          : "this database is not one of batch; choose another folder",
      database_->path()});
}

Expected<void> ResultStore::prepare() {
  const Expected<std::int64_t> version = database_->number("PRAGMA user_version");
  if (!version) return Unexpected(version.error());
  const Expected<std::int64_t> tables = database_->number("SELECT count(*) FROM sqlite_master");
  if (!tables) return Unexpected(tables.error());
  const bool fresh = *version == 0 && *tables == 0;
  if (!fresh) {
    if (Expected<void> fits = check_version(*version); !fits) return fits;
  }
  if (Expected<void> mode = database_->run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL"); !mode)
    return mode;
  if (fresh) {
    Expected<void> made = database_->run(fmt::format(
        "BEGIN IMMEDIATE; CREATE TABLE pairs ({}); CREATE TABLE about (key TEXT PRIMARY KEY, value TEXT NOT "
        "NULL); PRAGMA application_id = {}; PRAGMA user_version = {}; COMMIT",
        column_definitions(), kApplication, kVersion));
    if (!made) return made;
  }
  Expected<Statement> insert = database_->prepare(
      fmt::format("INSERT OR REPLACE INTO pairs ({}) VALUES ({})", column_list(false), column_list(true)));
  if (!insert) return Unexpected(insert.error());
  Expected<Statement> select =
      database_->prepare(fmt::format("SELECT {} FROM pairs WHERE job = ?", column_list(false)));
  if (!select) return Unexpected(select.error());
  insert_ = std::make_unique<Statement>(*std::move(insert));
  select_ = std::make_unique<Statement>(*std::move(select));
  return {};
}

Expected<std::optional<BatchAbout>> ResultStore::about() {
  Expected<Statement> statement = database_->prepare("SELECT key, value FROM about");
  if (!statement) return Unexpected(statement.error());
  std::map<std::string, std::string> texts;
  while (true) {
    const Expected<bool> row = statement->step();
    if (!row) return Unexpected(row.error());
    if (!*row) break;
    std::string key;
    statement->take(key);
    statement->take(texts[key]);
  }
  if (texts.empty()) return std::optional<BatchAbout>();
  return std::optional(BatchAbout{texts["program"], texts["list"], texts["list_hash"],
                                  std::strtoull(texts["jobs"].c_str(), nullptr, 10), texts["made_by"]});
}

Expected<void> ResultStore::set_about(const BatchAbout& about) {
  Expected<Statement> statement = database_->prepare(
      "INSERT OR REPLACE INTO about VALUES ('program', ?), ('list', ?), ('list_hash', ?), ('jobs', ?), "
      "('made_by', ?)");
  if (!statement) return Unexpected(statement.error());
  statement->bind(about.program);
  statement->bind(about.list);
  statement->bind(about.list_hash);
  statement->bind(std::to_string(about.jobs));
  statement->bind(about.made_by);
  return statement->run();
}

Expected<std::optional<PairRow>> ResultStore::find(std::uint32_t job) {
  select_->bind(job);
  const Expected<bool> found = select_->step();
  if (!found) return Unexpected(found.error());
  if (!*found) return std::optional<PairRow>();
  std::optional<PairRow> row(std::in_place);
  take_row(*select_, *row);
  select_->reset();
  return row;
}

Expected<std::int64_t> ResultStore::last_job() { return database_->number("SELECT max(job) FROM pairs"); }

Expected<void> ResultStore::record(const PairRow& row) {
  visit_columns(row, [this](const char*, const auto& value) { insert_->bind(value); });
  return insert_->run();
}

Expected<void> ResultStore::each(const std::function<Expected<void>(const PairRow&)>& visit) {
  Expected<Statement> statement =
      database_->prepare(fmt::format("SELECT {} FROM pairs ORDER BY job", column_list(false)));
  if (!statement) return Unexpected(statement.error());
  while (true) {
    const Expected<bool> found = statement->step();
    if (!found) return Unexpected(found.error());
    if (!*found) return {};
    PairRow row;
    take_row(*statement, row);
    if (Expected<void> visited = visit(row); !visited) return visited;
  }
}

Expected<void> ResultStore::write_lines() {
  std::string lines;
  Expected<void> read = each([&lines](const PairRow& row) -> Expected<void> {
    lines += json_line(row);
    return {};
  });
  if (!read) return read;
  return replace_file(lines_path(), lines);
}

Expected<void> ResultStore::finish() {
  if (Expected<void> written = write_lines(); !written) return written;
  insert_.reset();
  select_.reset();
  if (Expected<void> plain = database_->run("PRAGMA journal_mode = DELETE"); !plain) {
    // Somebody reads: the log stays beside the database, and nothing is lost.
    if (Expected<void> taken_in = database_->run("PRAGMA wal_checkpoint(PASSIVE)"); !taken_in) return taken_in;
  }
  if (database_->path() == database_path()) return {};
  const std::string made = database_->path();
  database_.reset();
  std::error_code failed;
  fs::rename(made, database_path(), failed);
  if (!failed) return {};
  return Unexpected(Error{ErrorCode::CannotWrite,
                          fmt::format("cannot be replaced: {}; check the folder", failed.message()), database_path()});
}

}  // namespace quadmatch::cli
