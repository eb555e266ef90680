#pragma once
/// One pair of a job list: read, match, verify, write, and what became of it.

#include "batch/job_list.hpp"
#include "batch/memory_gate.hpp"
#include "batch/pair_row.hpp"

namespace quadmatch::cli {

/// A job as a row that says nothing yet of its results.
[[nodiscard]] PairRow row_of(const Job& job);

/// Do a job, when there is memory for it. Whatever goes wrong stands in the row; nothing is thrown.
/// A job that runs out of memory all the same is tried again when no other runs.
[[nodiscard]] PairRow do_job(const Job& job, const JobList& list, MemoryGate& gate);

}  // namespace quadmatch::cli
