#include "batch_pair.hpp"

#include <exception>
#include <filesystem>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <quadmatch/io/read_mesh.hpp>

#include "batch/memory_need.hpp"
#include "console.hpp"
#include "dirt.hpp"
#include "match_report.hpp"
#include "matching.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

PairRow failed(const Job& job, std::string why) {
  PairRow row = row_of(job);
  row.status = status::kFailed;
  row.error = std::move(why);
  return row;
}

/// What was dirty in a mesh or had to be guessed when it was read.
void add_remarks(const MeshFile& file, std::vector<std::string>& remarks) {
  for (const std::string& note : file.notes) remarks.push_back(fmt::format("{}: {}", file.path, note));
  const std::string dirt = describe_dirt(file.mesh, "matching");
  if (!dirt.empty()) remarks.push_back(fmt::format("{}: {}", file.path, dirt));
}

void fill_optimality(const std::optional<Optimality>& optimality, PairRow& row) {
  if (!optimality) return;
  row.proved = optimality->proved ? 1 : 0;
  row.bound = optimality->bound;
  if (optimality->decision == Decision::NotAsked) return;
  row.answer = optimality->decision == Decision::Yes ? "yes" : optimality->decision == Decision::No ? "no" : "unknown";
}

void fill_figures(const MatchReport& report, PairRow& row) {
  row.source_vertices = report.source.vertices;
  row.source_faces = report.source.faces;
  row.target_vertices = report.target.vertices;
  row.target_faces = report.target.faces;
  row.matched_faces = report.matched_faces();
  row.matched_vertices = report.matched_vertices;
  row.regions = static_cast<std::uint32_t>(report.regions.size());
  row.ambiguous_faces = report.ambiguous_faces();
  row.source_unmatched_areas = report.source.unmatched_areas;
  row.target_unmatched_areas = report.target.unmatched_areas;
  Evidence all;
  for (const RegionReport& region : report.regions) {
    all.agreeing += region.evidence.agreeing;
    all.source_extraordinary += region.evidence.source_extraordinary;
    all.target_extraordinary += region.evidence.target_extraordinary;
  }
  if (!report.regions.empty()) row.confidence = all.confidence();
  row.status = report.matched_faces() > 0 ? status::kMatched : status::kUnmatched;
  fill_optimality(report.optimality, row);
}

/// Read a mesh under the name that the list gives it.
Expected<MeshFile> read_listed(const JobList& list, const std::string& path) {
  Expected<MeshFile> file = read_mesh(list.resolved(path));
  if (file) {
    file->path = path;
  } else {
    file.error().path = path;
  }
  return file;
}

/// Match what was read and write the match file, if one is wanted.
Expected<PairRow> match_pair(const Job& job, const JobList& list, const MeshFile& source, const MeshFile& target,
                             Stopwatch& stopwatch, PairRow row) {
  const MatchingArguments& matching = job.matching;
  Expected<MatchResult> result =
      match_as_asked(matching, {source.mesh, job.source}, {target.mesh, job.target}, matching.waves, {});
  if (!result) return Unexpected(result.error());
  row.matching_ms = stopwatch.lap();
  if (Expected<void> sound = check_sound(source.mesh, target.mesh, result->match); !sound) {
    return Unexpected(sound.error());
  }
  row.verifying_ms = stopwatch.lap();
  fill_figures(report_match(source.mesh, target.mesh, *result, !matching.anchors.empty()), row);
  if (!job.output.empty()) {
    const MatchFile file{side_of(source), side_of(target), std::move(result->match), settings_of(matching),
                         result->optimality};
    Expected<void> written = write_match(list.resolved(job.output), file);
    if (!written) {
      written.error().path = job.output;
      return Unexpected(written.error());
    }
  }
  row.writing_ms = stopwatch.lap();
  return row;
}

Expected<PairRow> do_pair(const Job& job, const JobList& list, PairRow row) {
  Stopwatch stopwatch;
  const Expected<MeshFile> source = read_listed(list, job.source);
  if (!source) return Unexpected(source.error());
  const Expected<MeshFile> target = read_listed(list, job.target);
  if (!target) return Unexpected(target.error());
  row.reading_ms = stopwatch.lap();
  std::vector<std::string> remarks;
  add_remarks(*source, remarks);
  add_remarks(*target, remarks);
  if (!remarks.empty()) row.remarks = joined(remarks, "; ");
  stopwatch.lap();
  return match_pair(job, list, *source, *target, stopwatch, std::move(row));
}

/// Files of a pair that would be lost or mixed up: an output that is one of the inputs under another name.
Expected<void> check_paths(const Job& job, const JobList& list) {
  if (job.output.empty()) return {};
  for (const std::string* input : {&job.source, &job.target}) {
    std::error_code missing;  // then it is not the same file
    if (!std::filesystem::equivalent(list.resolved(*input), list.resolved(job.output), missing)) continue;
    return Unexpected(Error{ErrorCode::BadArgument,
                            "this is an input and would be overwritten; choose another name for the output",
                            job.output});
  }
  return {};
}

Expected<std::uint64_t> estimated(const Job& job, const JobList& list) {
  std::vector<MeshSize> sizes;
  for (const std::string* path : {&job.source, &job.target}) {
    Expected<MeshSize> size = measure_mesh_file(list.resolved(*path));
    if (!size) {
      size.error().path = *path;
      return Unexpected(size.error());
    }
    sizes.push_back(*size);
  }
  return needed_memory(sizes[0], sizes[1]);
}

PairRow do_within(const Job& job, const JobList& list, const PairRow& row, MemoryGate::Share share) {
  const MemoryGate::Share held = std::move(share);
  const Expected<PairRow> done = do_pair(job, list, row);
  return done ? *done : failed(job, done.error().describe());
}

PairRow do_sound_job(const Job& job, const JobList& list, MemoryGate& gate) {
  if (Expected<void> fit = check_paths(job, list); !fit) return failed(job, fit.error().describe());
  const Expected<std::uint64_t> need = estimated(job, list);
  if (!need) return failed(job, need.error().describe());
  PairRow row = row_of(job);
  row.estimated_bytes = *need;
  if (*need > gate.limit()) {
    row.status = status::kRefused;
    row.error = fmt::format("the pair may need {} of memory and {} are allowed; give more by --memory",
                            byte_size(*need), byte_size(gate.limit()));
    return row;
  }
  try {
    return do_within(job, list, row, gate.enter(*need));
  } catch (const std::bad_alloc&) {
    return do_within(job, list, row, gate.enter_alone());
  }
}

}  // namespace

PairRow row_of(const Job& job) {
  PairRow row;
  row.job = job.number;
  row.line = job.line;
  row.name = job.name;
  row.source = job.source;
  row.target = job.target;
  row.options = options_text(job.matching);
  row.output = job.output;
  return row;
}

PairRow do_job(const Job& job, const JobList& list, MemoryGate& gate) {
  if (!job.fault.empty()) return failed(job, fmt::format("line {}: {}", job.line, job.fault));
  if (job.duplicate_of != 0) {
    PairRow row = row_of(job);
    row.status = status::kDuplicate;
    row.error = fmt::format("the same as job {}, which is done instead", job.duplicate_of);
    return row;
  }
  try {
    return do_sound_job(job, list, gate);
  } catch (const std::bad_alloc&) {
    return failed(job, "there is not enough memory; take smaller meshes, or a machine with more of it");
  } catch (const std::exception& error) {
    return failed(job, fmt::format("internal error: {}; please report it", error.what()));
  }
}

}  // namespace quadmatch::cli
