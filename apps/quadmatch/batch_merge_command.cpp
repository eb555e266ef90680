// quadmatch batch-merge FOLDER... -o RESULTS: the results of shards in one folder.

#include <filesystem>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "batch/result_store.hpp"
#include "batch_run.hpp"
#include "command.hpp"
#include "console.hpp"
#include "json.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter =
    R"(RESULTS becomes a folder as batch would have made it in one piece. Match files stay where they
are: batch wrote them beside the job list. Run it again when further shards are done; results of
an earlier batch-merge are replaced, those of batch never.

Where two folders have the same job, the one that is done counts.

Examples:
  quadmatch batch-merge shard-1 shard-2 -o results
  quadmatch batch-merge results/shard-* -o results && quadmatch batch-merge --help

Exit status: 0 all pairs are done; 1 some are missing, failed or were refused; 2 trouble.)";

struct BatchMergeArguments {
  std::vector<std::string> folders;
  std::string results;
  bool json = false;
  bool quiet = false;
};

struct Merging {
  ResultStore* into = nullptr;
  std::optional<BatchAbout> about = {};
  std::string first_folder = {};
};

/// May this folder be written, or does it hold what batch made?
Expected<void> check_output(const std::string& results) {
  std::error_code missing;
  if (!std::filesystem::exists(std::filesystem::path(results) / "results.sqlite", missing)) return {};
  const Expected<std::unique_ptr<ResultStore>> store = ResultStore::open_existing(results);
  if (!store) return Unexpected(store.error());
  const Expected<std::optional<BatchAbout>> about = (*store)->about();
  if (!about) return Unexpected(about.error());
  if (*about && (*about)->made_by == "batch-merge") return {};
  return Unexpected(
      Error{ErrorCode::CannotWrite, "these are results of batch and would be lost; choose another folder", results});
}

Expected<void> check_same_list(Merging& merging, const std::string& folder, const std::optional<BatchAbout>& about) {
  if (!about) return Unexpected(Error{ErrorCode::CannotRead, "there are no results here yet; run batch first", folder});
  if (!merging.about) {
    merging.about = about;
    merging.first_folder = folder;
    return {};
  }
  if (about->list_hash == merging.about->list_hash) return {};
  return Unexpected(Error{ErrorCode::BadArgument,
                          fmt::format("these results are of another job list ({}) than those in {} ({}); merge what "
                                      "belongs to one list",
                                      about->list, merging.first_folder, merging.about->list),
                          folder});
}

/// Take over a row, unless there is a better one.
Expected<void> add_row(ResultStore& into, const PairRow& row, const std::string& folder) {
  const Expected<std::optional<PairRow>> known = into.find(row.job);
  if (!known) return Unexpected(known.error());
  if (*known && row.done() && (*known)->done() && !same_results(row, **known)) {
    return Unexpected(Error{ErrorCode::BadArgument,
                            fmt::format("job {} has another result here than in the folders before; leave one of them "
                                        "out",
                                        row.job),
                            folder});
  }
  if (*known && ((*known)->done() || !row.done())) return {};
  return into.record(row);
}

Expected<void> add_folder(Merging& merging, const std::string& folder) {
  const Expected<std::unique_ptr<ResultStore>> store = ResultStore::open_existing(folder);
  if (!store) return Unexpected(store.error());
  const Expected<std::optional<BatchAbout>> about = (*store)->about();
  if (!about) return Unexpected(about.error());
  if (Expected<void> same = check_same_list(merging, folder, *about); !same) return same;
  return (*store)->each([&](const PairRow& row) { return add_row(*merging.into, row, folder); });
}

/// Numbers of jobs without a row, in words: "3 (2, 17, 40)".
std::string describe_missing(const std::vector<std::uint64_t>& missing) {
  constexpr std::size_t kMost = 5;
  std::vector<std::string> numbers;
  for (std::size_t k = 0; k < std::min(kMost, missing.size()); ++k) numbers.push_back(std::to_string(missing[k]));
  if (missing.size() > kMost) numbers.emplace_back("...");
  return fmt::format("{} (job {}); run their shards, then merge again", counted(missing.size(), "pair"),
                     joined(numbers));
}

struct Merged {
  BatchCounts counts;
  std::vector<std::uint64_t> missing;
};

Expected<Merged> count(ResultStore& store, std::uint64_t jobs) {
  Merged merged;
  std::uint64_t next = 1;
  Expected<void> counted_rows = store.each([&](const PairRow& row) -> Expected<void> {
    for (; next < row.job; ++next) merged.missing.push_back(next);
    ++next;
    ++merged.counts.jobs;
    merged.counts.add(row);
    return {};
  });
  if (!counted_rows) return Unexpected(counted_rows.error());
  for (; next <= jobs; ++next) merged.missing.push_back(next);
  return merged;
}

Expected<Merged> merge_folders(const BatchMergeArguments& arguments) {
  if (Expected<void> free = check_output(arguments.results); !free) return Unexpected(free.error());
  const Expected<std::unique_ptr<ResultStore>> into = ResultStore::open_anew(arguments.results);
  if (!into) return Unexpected(into.error());
  if (Expected<void> begun = (*into)->begin(); !begun) return Unexpected(begun.error());
  Merging merging{into->get()};
  for (const std::string& folder : arguments.folders) {
    if (Expected<void> added = add_folder(merging, folder); !added) return Unexpected(added.error());
  }
  merging.about->made_by = "batch-merge";
  if (Expected<void> kept = (*into)->set_about(*merging.about); !kept) return Unexpected(kept.error());
  if (Expected<void> committed = (*into)->commit(); !committed) return Unexpected(committed.error());
  Expected<Merged> merged = count(**into, merging.about->jobs);
  if (!merged) return merged;
  if (Expected<void> finished = (*into)->finish(); !finished) return Unexpected(finished.error());
  return merged;
}

bool tell(const BatchMergeArguments& arguments, const Merged& merged) {
  const BatchCounts& counts = merged.counts;
  if (arguments.json) {
    return print(json_text({{"rows", counts.jobs},
                            {"matched", counts.matched},
                            {"unmatched", counts.unmatched},
                            {"failed", counts.failed},
                            {"refused", counts.refused},
                            {"duplicates", counts.duplicates},
                            {"missing", merged.missing}}));
  }
  if (arguments.quiet) return true;
  Lines lines;
  lines.add("merged",
            fmt::format("{} of {}", counted(counts.jobs, "pair"), counted(arguments.folders.size(), "folder")));
  lines.add("done", describe(counts));
  if (!merged.missing.empty()) lines.add("missing", describe_missing(merged.missing));
  lines.add("written", (std::filesystem::path(arguments.results) / "results.sqlite").string());
  lines.add("", (std::filesystem::path(arguments.results) / "results.jsonl").string());
  return print(lines.render());
}

int run_batch_merge(const BatchMergeArguments& arguments) {
  const Expected<Merged> merged = merge_folders(arguments);
  if (!merged) return complain(merged.error());
  if (!tell(arguments, *merged)) return kTrouble;
  const bool all = merged->missing.empty() && merged->counts.failed + merged->counts.refused == 0;
  return all ? kSame : kDifferent;
}

}  // namespace

void add_batch_merge_command(CLI::App& program, Action& chosen) {
  BatchMergeArguments* arguments = nullptr;
  CLI::App* const verb = add_verb(program, "batch-merge", "Bring the results of batch on several machines together",
                                  arguments, run_batch_merge, chosen);
  verb->footer(kFooter);
  verb->add_option("FOLDER", arguments->folders, "Folders that batch wrote, of one job list")
      ->required()
      ->type_name("FOLDER");
  verb->add_option("-o,--output", arguments->results, "Folder of results to make")->required()->type_name("FOLDER");
  verb->add_flag("--json", arguments->json, "Print the counts as JSON");
  verb->add_flag("--quiet", arguments->quiet, "Print no summary");
}

}  // namespace quadmatch::cli
