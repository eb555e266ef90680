#pragma once
/// The jobs of a list that are still to be done, done by several threads, and each recorded as soon as it is.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "batch/job_list.hpp"
#include "batch/result_store.hpp"

namespace quadmatch::cli {

/// "2/5": every fifth job, from the second on.
struct Shard {
  std::uint32_t number = 1, of = 1;

  [[nodiscard]] bool has(std::uint32_t job) const { return (job - 1) % of == number - 1; }
};

/// Reads "2/5". @par Errors  BadArgument.
[[nodiscard]] Expected<Shard> parse_shard(const std::string& text);

struct BatchOptions {
  std::uint32_t threads = 1;
  std::uint64_t memory = 0;  ///< bytes that the pairs at work may need together
  Shard shard = {};
  bool retry = false;  ///< do failed jobs again
  bool quiet = false;
};

/// How many jobs of the shard there are, by what became of them.
struct BatchCounts {
  std::uint64_t jobs = 0;
  std::uint64_t before = 0;  ///< were done by an earlier run
  std::uint64_t matched = 0, unmatched = 0, failed = 0, refused = 0, duplicates = 0;
  std::uint64_t faces = 0, matched_faces = 0;  ///< of the sources of pairs that are done
  std::optional<PairRow> first_trouble = {};   ///< the first job that failed or was refused

  void add(const PairRow& row);
};

/// "12 matched, 1 failed".
[[nodiscard]] std::string describe(const BatchCounts& counts);

/// Do what is not done yet. What another run of the same list has done is left as it is, but for what was refused, and
/// what had failed where `retry` says so or the row of the list has changed.
///
/// @return      the counts of all jobs of the shard.
/// @par Errors  those of the store; BadArgument where a job that is done is another one in the list.
[[nodiscard]] Expected<BatchCounts> run_batch(const JobList& list, const BatchOptions& options, ResultStore& store);

/// "1,200 of 10,000 pairs, 3 failed; 210 pairs/s, 42 s left".
/// @param done, before  of `all`, in this run and earlier ones; @param seconds  that this run has taken.
[[nodiscard]] std::string progress_text(std::uint64_t done, std::uint64_t before, std::uint64_t all,
                                        std::uint64_t failed, double seconds);

}  // namespace quadmatch::cli
