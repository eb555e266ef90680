#pragma once
/// A results folder: `results.sqlite`, the one truth of what is done, and `results.jsonl`, written from it.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <quadmatch/mesh/expected.hpp>

#include "folder_lock.hpp"
#include "pair_row.hpp"
#include "sqlite.hpp"

namespace quadmatch::cli {

/// What the results belong to.
struct BatchAbout {
  std::string program;
  std::string list;          ///< path of the job list
  std::string list_hash;     ///< of its bytes
  std::uint64_t jobs = 0;    ///< in the list, of all shards
  std::string made_by = {};  ///< "batch" or "batch-merge"
};

class ResultStore {
 public:
  /// The layout of the tables, in `PRAGMA user_version`.
  static constexpr std::int64_t kVersion = 1;

  /// Take the folder for this process, and make it and its database where there are none.
  /// @par Errors  CannotWrite: another process has the folder, the database is of another version or program, or the
  ///              outside world does not allow it.
  [[nodiscard]] static Expected<std::unique_ptr<ResultStore>> open(const std::string& folder);
  /// The same, but there must be results.
  [[nodiscard]] static Expected<std::unique_ptr<ResultStore>> open_existing(const std::string& folder);
  /// The same, but begin anew beside the results there are, if any; `replace` puts the new ones in their place.
  [[nodiscard]] static Expected<std::unique_ptr<ResultStore>> open_anew(const std::string& folder);

  /// What it belongs to; nothing for a new one.
  [[nodiscard]] Expected<std::optional<BatchAbout>> about();
  [[nodiscard]] Expected<void> set_about(const BatchAbout& about);

  /// The row of a job, if there is one.
  [[nodiscard]] Expected<std::optional<PairRow>> find(std::uint32_t job);
  /// The largest number of a job that has a row; 0 for none.
  [[nodiscard]] Expected<std::int64_t> last_job();
  /// Keep a row, in the place of the one its job had. When this returns it outlives the process.
  [[nodiscard]] Expected<void> record(const PairRow& row);
  /// All rows by job number. Stops at the first error of `visit`.
  [[nodiscard]] Expected<void> each(const std::function<Expected<void>(const PairRow&)>& visit);

  /// Group what is recorded until the transaction is committed: for many rows at once.
  [[nodiscard]] Expected<void> begin() { return database_->run("BEGIN"); }
  [[nodiscard]] Expected<void> commit() { return database_->run("COMMIT"); }

  /// Leave one plain file that can be copied, and write the JSON Lines.
  [[nodiscard]] Expected<void> finish();

  [[nodiscard]] const std::string& folder() const { return folder_; }
  [[nodiscard]] std::string database_path() const { return in_folder("results.sqlite"); }
  [[nodiscard]] std::string lines_path() const { return in_folder("results.jsonl"); }

 private:
  ResultStore(std::string folder, FolderLock lock) : folder_(std::move(folder)), lock_(std::move(lock)) {}
  [[nodiscard]] static Expected<std::unique_ptr<ResultStore>> open_as(const std::string& folder, const char* name);
  [[nodiscard]] std::string in_folder(const char* name) const;
  [[nodiscard]] Expected<void> prepare();
  [[nodiscard]] Expected<void> check_version(std::int64_t version);
  [[nodiscard]] Expected<void> write_lines();

  std::string folder_;
  FolderLock lock_;
  std::unique_ptr<Database> database_;
  std::unique_ptr<Statement> insert_, select_;
};

}  // namespace quadmatch::cli
