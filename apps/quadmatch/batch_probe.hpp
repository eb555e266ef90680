#pragma once
/// A job that may bring the process down, tried where it can do no harm.

#include <optional>
#include <string>

#include "batch/job_list.hpp"

namespace quadmatch::cli {

/// Do a job in a process of its own, and throw the result away. @return why that process was ended; nothing where it
/// ended by itself. @pre no other thread runs.
[[nodiscard]] std::optional<std::string> probe_job(const Job& job, const JobList& list, std::uint64_t memory);

}  // namespace quadmatch::cli
