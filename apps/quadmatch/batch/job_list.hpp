#pragma once
/// A job list: a CSV file with a header, a pair of meshes in each row, and options of `match` for it.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <quadmatch/mesh/expected.hpp>

#include "../matching.hpp"

namespace quadmatch::cli {

struct Job {
  std::uint32_t number = 0;                           ///< of the row below the header, from 1
  std::uint64_t line = 0;                             ///< in the file, from 1
  std::string name = {};                              ///< the user's own, may be empty
  std::string source = {}, target = {}, output = {};  ///< as the list has them; output empty: no match file
  MatchingArguments matching = {};
  std::string fault = {};          ///< why it cannot be done, one sentence
  std::uint32_t duplicate_of = 0;  ///< the job that says the same, 0: none
};

struct JobList {
  std::string path;
  std::string folder;  ///< that paths in it are relative to; empty: the current one
  std::string hash;    ///< of its bytes, 16 hexadecimal digits
  std::vector<Job> jobs;

  /// Where a path of the list leads from here.
  [[nodiscard]] std::string resolved(const std::string& in_list) const;
};

/// Read a job list; `-` reads standard input.
///
/// The first row names the columns, in any order: `source` and `target`; if wanted `output` (the match file to write),
/// `name`, and options of `match` without their dashes (`algorithm`, `min-region`, ...). An empty cell leaves an
/// option as `defaults` has it; a flag is yes or no. A row that cannot be done is a job with a fault: it has another
/// number of fields than the header, no mesh, an option that does not exist so, or writes a file that another job
/// reads or writes.
///
/// @par Errors  CannotRead; Syntax for a header that names no columns, unknown ones or one twice; Empty without jobs.
/// @par Cost    O(size log #jobs).
[[nodiscard]] Expected<JobList> read_job_list(const std::string& path, const MatchingArguments& defaults);
/// The same from memory; `path` is what errors call it and what its folder is taken from.
[[nodiscard]] Expected<JobList> parse_job_list(std::string_view text, const std::string& path,
                                               const MatchingArguments& defaults);

}  // namespace quadmatch::cli
