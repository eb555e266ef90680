// quadmatch batch JOBS -o RESULTS: read the list, do what is not done yet, report.

#include <algorithm>
#include <thread>

#include <malloc.h>
#include <unistd.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "batch_run.hpp"
#include "command.hpp"
#include "console.hpp"
#include "inputs.hpp"
#include "json.hpp"
#include "matching.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter =
    R"(JOBS is a CSV file. Its first row names the columns, each further row is a pair:
  source,target,output,algorithm,time-limit
  a.obj,b.obj,ab.json,,
  "c, old.obj",c.obj,,exact,10
  source, target  meshes, relative to the folder of JOBS
  output          match file to write; empty: none
  name            a name of yours, kept with the results
  and the options below about matching, without their dashes, such as algorithm, orientation,
  min-region, no-positions (yes or no), anchor (several with blanks between). An empty cell
  leaves an option as it is given here.

RESULTS becomes a folder with
  results.sqlite  a row for each pair in the table pairs, as soon as it is done
  results.jsonl   the same as JSON Lines in the order of the list, when all is done; it has no
                  times, so that equal results are equal files

Kill it whenever you like: the same command goes on where it was. What failed stays failed until
--retry; what was refused for its memory is tried again. Rows may be added to the list's end.

Examples:
  quadmatch batch jobs.csv -o results
  quadmatch batch jobs.csv -o results --threads 8 --memory 16G --no-positions
  quadmatch batch jobs.csv -o shard-2 --shard 2/5    on the second of five machines, and then
  quadmatch batch-merge shard-* -o results
  sqlite3 results/results.sqlite "SELECT * FROM pairs WHERE matched_faces < source_faces"

Exit status: 0 all pairs are done; 1 some failed or were refused; 2 trouble, run it again.)";

struct BatchArguments {
  std::string list, results, shard = "1/1";
  MatchingArguments matching;
  std::uint32_t threads = 0;
  std::uint64_t memory = 0;
  bool retry = false;
  bool json = false;
  bool quiet = false;
};

/// Three quarters of what the machine has.
std::uint64_t usual_memory() {
  const auto bytes =
      static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  return bytes / 4 * 3;
}

/// Memory of a large pair goes back to the system with the pair: the C library must not keep what threads have freed,
/// but for so little that giving and taking it would cost small pairs more.
void return_freed_memory() {
  constexpr int kKept = 1 << 22;
  ::mallopt(M_MMAP_THRESHOLD, kKept);
  ::mallopt(M_TRIM_THRESHOLD, kKept);
}

std::string as_text(const BatchArguments& arguments, const JobList& list, const BatchCounts& counts,
                    const ResultStore& store, double milliseconds) {
  Lines lines;
  lines.add("jobs", fmt::format("{}: {}", display_name(list.path), counted(list.jobs.size(), "pair")));
  if (counts.jobs != list.jobs.size()) {
    lines.add("shard", fmt::format("{}: {}", arguments.shard, counted(counts.jobs, "pair")));
  }
  if (counts.before > 0) lines.add("before", fmt::format("{} were done already", grouped(counts.before)));
  lines.add("done", describe(counts));
  lines.add("faces", fmt::format("{} in the sources, {} of them matched", grouped(counts.faces),
                                 percent(counts.matched_faces, counts.faces)));
  if (counts.first_trouble) {
    lines.add("trouble",
              fmt::format("job {}: {}", counts.first_trouble->job, counts.first_trouble->error.value_or("")));
    if (counts.failed + counts.refused > 1) lines.add("", "the rest stands in the results under status and error");
  }
  lines.add("time", duration(milliseconds));
  lines.add("written", store.database_path());
  lines.add("", store.lines_path());
  return lines.render();
}

std::string as_json(const JobList& list, const BatchCounts& counts, const ResultStore& store, double milliseconds) {
  return json_text({{"list", list.path},
                    {"jobs", list.jobs.size()},
                    {"shard_jobs", counts.jobs},
                    {"done_before", counts.before},
                    {"matched", counts.matched},
                    {"unmatched", counts.unmatched},
                    {"failed", counts.failed},
                    {"refused", counts.refused},
                    {"duplicates", counts.duplicates},
                    {"source_faces", counts.faces},
                    {"matched_faces", counts.matched_faces},
                    {"milliseconds", rounded(milliseconds)},
                    {"database", store.database_path()},
                    {"lines", store.lines_path()}});
}

int run_batch_command(const BatchArguments& arguments) {
  if (const Expected<void> fit = check_matching(arguments.matching); !fit) return complain(fit.error());
  const Expected<Shard> shard = parse_shard(arguments.shard);
  if (!shard) return complain(shard.error());
  const BatchOptions options{
      .threads = arguments.threads != 0 ? arguments.threads : std::max(1U, std::thread::hardware_concurrency()),
      .memory = arguments.memory != 0 ? arguments.memory : usual_memory(),
      .shard = *shard,
      .retry = arguments.retry,
      .quiet = arguments.quiet};
  Stopwatch stopwatch;
  const Expected<JobList> list = read_job_list(arguments.list, arguments.matching);
  if (!list) return complain(list.error());
  const Expected<std::unique_ptr<ResultStore>> store = ResultStore::open(arguments.results);
  if (!store) return complain(store.error());
  return_freed_memory();
  const Expected<BatchCounts> counts = run_batch(*list, options, **store);
  if (!counts) return complain(counts.error());
  const double milliseconds = stopwatch.lap();
  if (arguments.json && !print(as_json(*list, *counts, **store, milliseconds))) return kTrouble;
  if (!arguments.json && !arguments.quiet && !print(as_text(arguments, *list, *counts, **store, milliseconds))) {
    return kTrouble;
  }
  return counts->failed + counts->refused > 0 ? kDifferent : kSame;
}

}  // namespace

void add_batch_command(CLI::App& program, Action& chosen) {
  BatchArguments* arguments = nullptr;
  CLI::App* const verb =
      add_verb(program, "batch", "Match many pairs; can be killed and goes on", arguments, run_batch_command, chosen);
  verb->footer(kFooter);
  verb->add_option("JOBS", arguments->list, "Job list, CSV; - reads standard input")->required()->type_name("FILE");
  verb->add_option("-o,--output", arguments->results, "Folder of results to make, or to go on with")
      ->required()
      ->type_name("FOLDER");
  verb->add_option("--threads", arguments->threads, "Pairs at a time; 0: as many as there are processors")
      ->type_name("N")
      ->check(CLI::Range(0U, 4096U).description(""))
      ->capture_default_str();
  verb->add_option("--memory", arguments->memory,
                   "What the pairs at work may need together, such as 800M or 16G; a pair that may need more by itself "
                   "is refused. Without it three quarters of the machine's")
      ->transform(CLI::AsSizeValue(true).description(""))
      ->type_name("BYTES");
  verb->add_option("--shard", arguments->shard, "Only every n-th pair, from the i-th on: one machine's part of a farm")
      ->type_name("I/N")
      ->capture_default_str();
  verb->add_flag("--retry", arguments->retry, "Try again what failed");
  add_matching_options(*verb, arguments->matching);
  verb->add_flag("--json", arguments->json, "Print the counts as JSON");
  verb->add_flag("--quiet", arguments->quiet, "Print neither summary nor progress");
}

}  // namespace quadmatch::cli
