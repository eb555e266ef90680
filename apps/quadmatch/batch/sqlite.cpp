#include "sqlite.hpp"

#include <fmt/format.h>

namespace quadmatch::cli {
namespace {

/// How long another program may hold the database before we give up.
constexpr int kPatience = 5000;  // milliseconds

/// What is wrong, and what to do.
std::string sentence(int code, const char* said) {
  switch (code) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program holds this database; end it, then run the same command again, which goes on from here";
    case SQLITE_FULL:
      return "there is no room left for this database; make room, then run the same command again, which goes on from "
             "here";
    case SQLITE_NOTADB:
    case SQLITE_CORRUPT:
      return "this is no database, or a damaged one; move it away, or choose another folder";
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_AUTH:
      return "this database may not be written; change its permissions, or choose another folder";
    case SQLITE_CANTOPEN:
      return "this database cannot be opened; check the folder and its permissions";
    case SQLITE_IOERR:
      return "this database cannot be read or written (a full disk, a limit of file size, or a failing one); see to "
             "it, "
             "then run the same command again, which goes on from here";
    default:
      return fmt::format("the database answers: {}", said);
  }
}

}  // namespace

void Statement::bind(std::int64_t value) { sqlite3_bind_int64(statement_.get(), ++parameter_, value); }
void Statement::bind(double value) { sqlite3_bind_double(statement_.get(), ++parameter_, value); }
void Statement::bind_null() { sqlite3_bind_null(statement_.get(), ++parameter_); }
void Statement::bind(std::string_view value) {
  sqlite3_bind_text(statement_.get(), ++parameter_, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT);
}
void Statement::bind_bytes(std::string_view value) {
  sqlite3_bind_blob(statement_.get(), ++parameter_, value.data(), static_cast<int>(value.size()), SQLITE_TRANSIENT);
}

std::int64_t Statement::next_integer() { return sqlite3_column_int64(statement_.get(), column_++); }
void Statement::take(double& value) { value = sqlite3_column_double(statement_.get(), column_++); }
void Statement::take(std::string& value) {
  // A text may hold zero bytes, so its size counts, not its end.
  const void* const bytes = sqlite3_column_blob(statement_.get(), column_);
  const int size = sqlite3_column_bytes(statement_.get(), column_++);
  value.assign(static_cast<const char*>(bytes), bytes == nullptr ? 0 : static_cast<std::size_t>(size));
}
bool Statement::next_is_null() {
  if (sqlite3_column_type(statement_.get(), column_) != SQLITE_NULL) return false;
  ++column_;
  return true;
}

Expected<bool> Statement::step() {
  column_ = 0;
  parameter_ = 0;
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) {
    sqlite3_reset(statement_.get());
    return false;
  }
  const Error error = database_->error();
  sqlite3_reset(statement_.get());
  return Unexpected(error);
}

void Statement::reset() { sqlite3_reset(statement_.get()); }

Expected<void> Statement::run() {
  const Expected<bool> stepped = step();
  if (!stepped) return Unexpected(stepped.error());
  if (*stepped) sqlite3_reset(statement_.get());
  return {};
}

Expected<std::unique_ptr<Database>> Database::open(const std::string& path, Access access) {
  const int flags = access == Access::Read ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
  sqlite3* raw = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &raw, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  std::unique_ptr<Database> database(new Database(raw, path));
  if (code != SQLITE_OK) return Unexpected(database->error());
  sqlite3_busy_timeout(raw, kPatience);
  return database;
}

Expected<void> Database::run(const std::string& sql) {
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) return Unexpected(error());
  return {};
}

Expected<Statement> Database::prepare(const std::string& sql) {
  sqlite3_stmt* raw = nullptr;
  if (sqlite3_prepare_v2(database_.get(), sql.c_str(), static_cast<int>(sql.size()), &raw, nullptr) != SQLITE_OK) {
    return Unexpected(error());
  }
  return Statement(raw, *this);
}

Expected<std::int64_t> Database::number(const std::string& sql) {
  Expected<Statement> statement = prepare(sql);
  if (!statement) return Unexpected(statement.error());
  const Expected<bool> row = statement->step();
  if (!row) return Unexpected(row.error());
  return *row ? statement->next_integer() : 0;
}

Error Database::error() const {
  const int code = database_ ? sqlite3_errcode(database_.get()) & 0xff : SQLITE_NOMEM;
  const char* const said = database_ ? sqlite3_errmsg(database_.get()) : "out of memory";
  return Error{ErrorCode::CannotWrite, sentence(code, said), path_};
}

}  // namespace quadmatch::cli
