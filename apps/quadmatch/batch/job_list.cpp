#include "job_list.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <quadmatch/io/file.hpp>

#include "../inputs.hpp"
#include "../text.hpp"
#include "csv_rows.hpp"
#include "row_options.hpp"

namespace quadmatch::cli {
namespace {

/// The columns that are no options.
const std::set<std::string> kOwnColumns{"source", "target", "output", "name"};

Expected<void> check_header(const CsvRow& header, const RowOptions& options) {
  const auto refuse = [&header](std::string message) {
    return Unexpected(Error{ErrorCode::Syntax, std::move(message), {}, header.line});
  };
  if (!header.fault.empty()) return refuse(header.fault);
  std::set<std::string> seen;
  for (const std::string& column : header.fields) {
    if (!kOwnColumns.contains(column) && !options.knows(column)) {
      return refuse(
          fmt::format("\"{}\" is no column of a job list; the first row names the columns, of source, target, output, "
                      "name, {}",
                      column, joined(options.columns())));
    }
    if (!seen.insert(column).second)
      return refuse(fmt::format("column {} is named twice; leave one of them out", column));
  }
  for (const char* needed : {"source", "target"}) {
    if (!seen.contains(needed)) return refuse(fmt::format("there is no column {}; name it in the first row", needed));
  }
  return {};
}

/// What of a row can be wrong without a look at the others.
std::string fault_of(const Job& job) {
  for (const auto& [what, path] : {std::pair("source", &job.source), std::pair("target", &job.target)}) {
    if (path->empty()) return fmt::format("there is no {}; name a mesh", what);
    if (*path == "-")
      return fmt::format("the {} is -, but standard input has room for one mesh only; name a file", what);
  }
  if (job.output == "-") return "the output is -, but standard output has no room for match files; name a file";
  for (const std::string* path : {&job.source, &job.target, &job.output}) {
    if (path->find('\0') != std::string::npos) return "a path holds a zero byte; correct it";
  }
  return {};
}

Job read_row(const CsvRow& row, const std::vector<std::string>& columns, RowOptions& options) {
  Job job{.line = row.line, .fault = row.fault};
  if (!job.fault.empty()) return job;
  if (row.fields.size() != columns.size()) {
    job.fault = fmt::format("the row has {}, but the header names {}; put fields with commas in quotes",
                            counted(row.fields.size(), "field"), columns.size());
    return job;
  }
  const std::map<std::string, std::string*> own{
      {"source", &job.source}, {"target", &job.target}, {"output", &job.output}, {"name", &job.name}};
  std::map<std::string, std::string> cells;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto found = own.find(columns[k]);
    (found != own.end() ? *found->second : cells[columns[k]]) = row.fields[k];
  }
  job.fault = fault_of(job);
  const Expected<MatchingArguments>& matching = options.parse(cells);
  if (matching) job.matching = *matching;
  if (!matching && job.fault.empty()) job.fault = matching.error().describe();
  return job;
}

/// One spelling for "a/../b.obj" and "b.obj".
std::string plain(const std::string& path) { return std::filesystem::path(path).lexically_normal().string(); }

/// Of jobs that say the same the first is done.
void find_duplicates(std::vector<Job>& jobs) {
  std::map<std::vector<std::string>, std::uint32_t> first;
  for (Job& job : jobs) {
    if (!job.fault.empty()) continue;
    std::vector<std::string> said{plain(job.source), plain(job.target), plain(job.output), options_text(job.matching)};
    const auto [known, is_new] = first.emplace(std::move(said), job.number);
    if (!is_new) job.duplicate_of = known->second;
  }
}

/// No job writes what another one reads or writes: what comes of that would depend on which is done first.
void find_clashes(std::vector<Job>& jobs) {
  std::map<std::string, std::uint32_t> read, written;
  for (const Job& job : jobs) {
    if (!job.fault.empty() || job.duplicate_of != 0) continue;
    read.emplace(plain(job.source), job.number);
    read.emplace(plain(job.target), job.number);
  }
  for (Job& job : jobs) {
    if (!job.fault.empty() || job.duplicate_of != 0 || job.output.empty()) continue;
    const auto reader = read.find(plain(job.output));
    if (reader != read.end()) {
      job.fault = fmt::format("the output {} is a mesh of job {} and would be overwritten; choose another name",
                              job.output, reader->second);
      continue;
    }
    const auto [writer, is_new] = written.emplace(plain(job.output), job.number);
    if (!is_new) {
      job.fault = fmt::format("job {} writes {} already; choose another name", writer->second, job.output);
    }
  }
}

}  // namespace

std::string JobList::resolved(const std::string& in_list) const {
  return folder.empty() ? in_list : (std::filesystem::path(folder) / in_list).string();
}

Expected<JobList> parse_job_list(std::string_view text, const std::string& path, const MatchingArguments& defaults) {
  const auto in_list = [&path](Error error) {
    error.path = display_name(path);
    return Unexpected(std::move(error));
  };
  const std::vector<CsvRow> rows = csv_rows(text);
  if (rows.size() < 2) {
    return in_list({ErrorCode::Empty,
                    "there are no jobs; the first row names the columns, such as source,target, and each further row "
                    "is a pair"});
  }
  RowOptions options(defaults);
  if (const Expected<void> header = check_header(rows.front(), options); !header) return in_list(header.error());

  JobList list{path,
               path == "-" ? "" : std::filesystem::path(path).parent_path().string(),
               fmt::format("{:016x}", XXH3_64bits(text.data(), text.size())),
               {}};
  list.jobs.reserve(rows.size() - 1);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    list.jobs.push_back(read_row(rows[k], rows.front().fields, options));
    list.jobs.back().number = static_cast<std::uint32_t>(k);
  }
  find_duplicates(list.jobs);
  find_clashes(list.jobs);
  return list;
}

Expected<JobList> read_job_list(const std::string& path, const MatchingArguments& defaults) {
  const Expected<FileBytes> bytes = read_file(path);
  if (!bytes) return Unexpected(bytes.error());
  return parse_job_list(bytes->view(), path, defaults);
}

}  // namespace quadmatch::cli
