#pragma once
/// SQLite as values: a database that closes itself, statements that finalize themselves, errors in our own form.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <sqlite3.h>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::cli {

class Database;

/// A prepared statement. Parameters and columns are counted from where the last one was, so that they are given and
/// taken in the order in which they stand.
class Statement {
 public:
  void bind(std::int64_t value);
  void bind(std::uint32_t value) { bind(static_cast<std::int64_t>(value)); }
  void bind(std::uint64_t value) { bind(static_cast<std::int64_t>(value)); }
  void bind(double value);
  void bind(std::string_view value);
  void bind(const std::string& value) { bind(std::string_view(value)); }
  /// Bytes that are no text; `take` a string to have them again.
  void bind_bytes(std::string_view value);
  template <class Value>
  void bind(const std::optional<Value>& value) {
    value ? bind(*value) : bind_null();
  }
  void bind_null();

  void take(std::uint32_t& value) { value = static_cast<std::uint32_t>(next_integer()); }
  void take(std::int64_t& value) { value = next_integer(); }
  void take(std::uint64_t& value) { value = static_cast<std::uint64_t>(next_integer()); }
  void take(double& value);
  void take(std::string& value);
  template <class Value>
  void take(std::optional<Value>& value) {
    if (next_is_null()) return;
    take(value.emplace());
  }

  /// Go to the next row, first binding anew after the last one. @return is there a row?
  /// @par Errors  CannotWrite, with the reason of SQLite and what to do.
  [[nodiscard]] Expected<bool> step();
  /// Begin anew before the last row, and let go of the database.
  void reset();
  /// Step once, to the end: for what gives no rows.
  [[nodiscard]] Expected<void> run();

 private:
  friend class Database;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  Statement(sqlite3_stmt* statement, const Database& of) : statement_(statement), database_(&of) {}

  std::int64_t next_integer();
  bool next_is_null();

  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
  const Database* database_;
  int parameter_ = 0;
  int column_ = 0;
};

class Database {
 public:
  enum class Access { Read, Write };

  /// Open a database; Write makes the file where there is none.
  /// @par Errors  CannotRead, CannotWrite.
  [[nodiscard]] static Expected<std::unique_ptr<Database>> open(const std::string& path, Access access);
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// Run statements that give nothing.
  [[nodiscard]] Expected<void> run(const std::string& sql);
  /// @par Errors  CannotRead where the tables are not those expected.
  [[nodiscard]] Expected<Statement> prepare(const std::string& sql);
  /// The one number that a statement gives.
  [[nodiscard]] Expected<std::int64_t> number(const std::string& sql);

  [[nodiscard]] const std::string& path() const { return path_; }
  /// What SQLite said last, as an error that names the file.
  [[nodiscard]] Error error() const;

 private:
  struct Close {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
  };
  Database(sqlite3* database, std::string path) : database_(database), path_(std::move(path)) {}

  std::unique_ptr<sqlite3, Close> database_;
  std::string path_;
};

}  // namespace quadmatch::cli
