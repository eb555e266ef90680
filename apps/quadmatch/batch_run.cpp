// A pipeline of oneTBB: jobs come in by number, are done beside each other, and are recorded one at a time.

#include "batch_run.hpp"

#include <atomic>
#include <charconv>
#include <chrono>
#include <string_view>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include "batch/at_work.hpp"
#include "batch_pair.hpp"
#include "batch_probe.hpp"
#include "console.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// The result of an earlier run, where it is one of this job.
Expected<std::optional<PairRow>> earlier_result(const Job& job, const JobList& list, bool retry, ResultStore& store) {
  Expected<std::optional<PairRow>> found = store.find(job.number);
  if (!found || !found->has_value()) return found;
  const PairRow& row = **found;
  const bool same = same_job(row, row_of(job));
  if (row.done() && !same) {
    return Unexpected(
        Error{ErrorCode::BadArgument,
              fmt::format("job {} is {} with {} here, but {} with {} was done under this number; take another folder "
                          "for a changed list (rows may be added at its end)",
                          job.number, job.source, job.target, row.source, row.target),
              list.path});
  }
  const bool again = !same || row.status == status::kRefused || (row.status == status::kFailed && retry);
  if (again) found->reset();
  return found;
}

/// The jobs to do, and the counts of those that are done.
Expected<std::vector<const Job*>> jobs_to_do(const JobList& list, const BatchOptions& options, ResultStore& store,
                                             BatchCounts& counts) {
  const Expected<std::int64_t> last = store.last_job();
  if (!last) return Unexpected(last.error());
  if (*last > static_cast<std::int64_t>(list.jobs.size())) {
    return Unexpected(Error{ErrorCode::BadArgument,
                            fmt::format("there are {}, but job {} was done before; take another folder for a changed "
                                        "list (rows may be added at its end)",
                                        counted(list.jobs.size(), "job"), *last),
                            list.path});
  }
  std::vector<const Job*> to_do;
  for (const Job& job : list.jobs) {
    if (!options.shard.has(job.number)) continue;
    ++counts.jobs;
    if (*last == 0) {  // a new folder: there is nothing to look for
      to_do.push_back(&job);
      continue;
    }
    const Expected<std::optional<PairRow>> row = earlier_result(job, list, options.retry, store);
    if (!row) return Unexpected(row.error());
    if (*row) {
      ++counts.before;
      counts.add(**row);
    } else {
      to_do.push_back(&job);
    }
  }
  return to_do;
}

/// Says how far the work is: on a terminal all the time, in a log once a minute.
class Watch {
 public:
  Watch(const BatchOptions& options, const BatchCounts& counts)
      : progress_(!options.quiet), log_(!options.quiet && ::isatty(STDERR_FILENO) == 0), counts_(&counts) {}

  void one_more() {
    ++done_;
    const Clock::time_point now = Clock::now();
    const bool log_now = log_ && now - logged_ >= std::chrono::minutes(1);
    if (!log_now && !progress_.visible()) return;
    const std::string text = progress_text(done_, counts_->before, counts_->jobs, counts_->failed + counts_->refused,
                                           std::chrono::duration<double>(now - began_).count());
    if (log_now) complain(text);
    if (log_now) logged_ = now;
    progress_.line(text);
  }

 private:
  Progress progress_;
  bool log_;
  const BatchCounts* counts_;
  std::uint64_t done_ = 0;
  Clock::time_point began_ = Clock::now();
  Clock::time_point logged_ = began_;
};

/// Two runs that ended at the same job are no chance any more: such a job is tried in a process of its own, and where
/// it brings that down as well it has failed. The rest is left in `jobs`.
Expected<void> try_suspects(std::vector<const Job*>& jobs, const JobList& list, const BatchOptions& options,
                            ResultStore& store, AtWork& at_work, BatchCounts& counts) {
  constexpr std::uint32_t kSuspicious = 2;
  std::vector<const Job*> sound;
  for (const Job* job : jobs) {
    if (at_work.ends(job->number) < kSuspicious) {
      sound.push_back(job);
      continue;
    }
    at_work.begin(job->number);
    const std::optional<std::string> fault = probe_job(*job, list, options.memory);
    if (!fault) {
      at_work.end(job->number);
      sound.push_back(job);
      continue;
    }
    PairRow row = row_of(*job);
    row.status = status::kFailed;
    row.error = *fault;
    if (Expected<void> kept = store.record(row); !kept) return kept;
    at_work.end(job->number);
    counts.add(row);
  }
  jobs = std::move(sound);
  return {};
}

/// Do jobs and record them. @return the first error of the store; what was recorded until then stays.
Expected<void> run_pipeline(const std::vector<const Job*>& jobs, const JobList& list, const BatchOptions& options,
                            ResultStore& store, AtWork& at_work, BatchCounts& counts) {
  MemoryGate gate(options.memory);
  Watch watch(options, counts);
  Expected<void> outcome;
  std::atomic<bool> stop = false;
  std::size_t next = 0;
  const auto take = [&](tbb::flow_control& flow) -> std::size_t {
    if (next < jobs.size() && !stop) return next++;
    flow.stop();
    return 0;
  };
  const auto work = [&](std::size_t job) {
    at_work.begin(jobs[job]->number);
    return do_job(*jobs[job], list, gate);
  };
  const auto record = [&](const PairRow& row) {
    if (stop) return;
    if (Expected<void> kept = store.record(row); !kept) {
      outcome = Unexpected(kept.error());
      stop = true;
      return;
    }
    at_work.end(row.job);
    counts.add(row);
    watch.one_more();
  };
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, options.threads);
  tbb::task_arena arena(static_cast<int>(options.threads));
  arena.execute([&] {
    tbb::parallel_pipeline(options.threads,
                           tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, take) &
                               tbb::make_filter<std::size_t, PairRow>(tbb::filter_mode::parallel, work) &
                               tbb::make_filter<PairRow, void>(tbb::filter_mode::serial_out_of_order, record));
  });
  return outcome;
}

}  // namespace

Expected<Shard> parse_shard(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  const bool slash = number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto of = slash ? std::from_chars(number.ptr + 1, end, shard.of) : number;
  if (slash && of.ec == std::errc() && of.ptr == end && shard.number >= 1 && shard.number <= shard.of) return shard;
  return Unexpected(
      Error{ErrorCode::BadArgument,
            fmt::format("--shard {}: this is no shard; write i/n with i from 1 to n, such as 2/5", text)});
}

void BatchCounts::add(const PairRow& row) {
  const bool trouble = row.status == status::kFailed || row.status == status::kRefused;
  matched += row.status == status::kMatched;
  unmatched += row.status == status::kUnmatched;
  failed += row.status == status::kFailed;
  refused += row.status == status::kRefused;
  duplicates += row.status == status::kDuplicate;
  faces += row.source_faces.value_or(0);
  matched_faces += row.matched_faces.value_or(0);
  if (trouble && (!first_trouble || row.job < first_trouble->job)) first_trouble = row;
}

Expected<BatchCounts> run_batch(const JobList& list, const BatchOptions& options, ResultStore& store) {
  BatchCounts counts;
  Expected<std::vector<const Job*>> jobs = jobs_to_do(list, options, store, counts);
  if (!jobs) return Unexpected(jobs.error());
  const Expected<std::unique_ptr<AtWork>> at_work = AtWork::open(store.folder());
  if (!at_work) return Unexpected(at_work.error());
  const BatchAbout about{"quadmatch " QUADMATCH_VERSION, list.path, list.hash, list.jobs.size(), "batch"};
  if (Expected<void> kept = store.set_about(about); !kept) return Unexpected(kept.error());
  if (Expected<void> tried = try_suspects(*jobs, list, options, store, **at_work, counts); !tried) {
    return Unexpected(tried.error());
  }
  if (Expected<void> done = run_pipeline(*jobs, list, options, store, **at_work, counts); !done) {
    return Unexpected(done.error());
  }
  if (Expected<void> finished = store.finish(); !finished) return Unexpected(finished.error());
  return counts;
}

std::string describe(const BatchCounts& counts) {
  std::vector<std::string> parts{fmt::format("{} matched", grouped(counts.matched))};
  if (counts.unmatched > 0) parts.push_back(fmt::format("{} with nothing in common", grouped(counts.unmatched)));
  if (counts.failed > 0) parts.push_back(fmt::format("{} failed", grouped(counts.failed)));
  if (counts.refused > 0) parts.push_back(fmt::format("{} refused", grouped(counts.refused)));
  if (counts.duplicates > 0) parts.push_back(counted(counts.duplicates, "duplicate"));
  return joined(parts);
}

std::string progress_text(std::uint64_t done, std::uint64_t before, std::uint64_t all, std::uint64_t failed,
                          double seconds) {
  std::string text = fmt::format("{} of {}", grouped(before + done), counted(all, "pair"));
  if (failed > 0) text += fmt::format(", {} failed", grouped(failed));
  if (done == 0 || seconds <= 0) return text;
  const double rate = static_cast<double>(done) / seconds;
  const auto left = static_cast<std::uint64_t>(static_cast<double>(all - before - done) / rate);
  const std::string time = left >= 3600 ? fmt::format("{} h {:02} min", left / 3600, left / 60 % 60)
                           : left >= 60 ? fmt::format("{} min {:02} s", left / 60, left % 60)
                                        : fmt::format("{} s", left);
  return text + fmt::format("; {} pairs/s, {} left",
                            rate < 10 ? fmt::format("{:.1f}", rate) : fmt::format("{:.0f}", rate), time);
}

}  // namespace quadmatch::cli
