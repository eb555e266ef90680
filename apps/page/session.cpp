#include "session.hpp"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/report/report.hpp>
#include <quadmatch/use/transfer.hpp>
#include <quadmatch/verify/verify.hpp>

#include "../quadmatch/dirt.hpp"
#include "../quadmatch/merge_report.hpp"
#include "../quadmatch/transfer_report.hpp"

namespace quadmatch::page {
namespace {

using Clock = std::chrono::steady_clock;

Unexpected<Error> refuse(std::string message, std::string path = {}) {
  return Unexpected(Error{ErrorCode::BadArgument, std::move(message), std::move(path)});
}

/// Milliseconds since it was made or last asked.
class Stopwatch {
 public:
  double lap() {
    const Clock::time_point now = Clock::now();
    return std::chrono::duration<double, std::milli>(now - std::exchange(began_, now)).count();
  }

 private:
  Clock::time_point began_ = Clock::now();
};

MatchSide side_of(const MeshFile& file) { return {file.path, file.mesh.vertex_count(), file.mesh.face_count()}; }

/// All of a text as a number from `least` to `most`, every one of which a double holds exactly.
bool parse_number(const std::string& text, double least, double most, double& number) {
  char* stop = nullptr;
  const double parsed = std::strtod(text.c_str(), &stop);  // libc++ has no std::from_chars of it
  if (text.empty() || stop != text.c_str() + text.size() || !(parsed >= least && parsed <= most)) return false;
  number = parsed;
  return true;
}

template <class Choices>
bool choose_one(const Choices& choices, const std::string& value, std::string& chosen) {
  if (choices.find(value) == choices.end()) return false;
  chosen = value;
  return true;
}

/// The format of a file to save.
Expected<Format> format_of(const std::string& name) {
  const std::optional<Format> format = format_of_path(name);
  if (!format) return refuse("the name does not tell the format; end it in .obj, .ply, .off or .usda", name);
  return *format;
}

std::vector<std::pair<std::string, std::string>> program() { return {{"program", "quadmatch " QUADMATCH_VERSION}}; }

}  // namespace

Expected<std::vector<std::string>> Session::read(Slot slot, const FileBytes& bytes, const std::string& name) {
  std::optional<MeshFile>& place = files_[static_cast<std::size_t>(slot)];
  place.reset();
  if (slot != Slot::Other) result_.reset();
  Expected<MeshFile> file = parse_mesh(bytes, name, format_of_path(name));
  if (!file) return Unexpected(std::move(file).error());
  std::vector<std::string> warnings;
  for (const std::string& note : file->notes) warnings.push_back(fmt::format("{}: {}", name, note));
  const std::string dirt = cli::describe_dirt(file->mesh, "matching");
  if (!dirt.empty()) warnings.push_back(fmt::format("{}: {}", name, dirt));
  place = *std::move(file);
  return warnings;
}

Expected<void> Session::choose(std::string_view name, const std::string& value) {
  constexpr double kMostSeconds = 1e9;
  bool known = false;
  if (name == "algorithm") {
    known = choose_one(cli::algorithm_choices(), value, arguments_.algorithm);
  } else if (name == "orientation") {
    known = choose_one(cli::orientation_choices(), value, arguments_.orientation);
  } else if (name == "positions") {
    known = value == "true" || value == "false";
    if (known) arguments_.no_positions = value == "false";
  } else if (name == "min-region") {
    double faces = 0;
    known = parse_number(value, 0.0, 0xffffffff, faces) && faces == std::floor(faces);
    if (known) arguments_.least_region = static_cast<std::uint32_t>(faces);
  } else if (name == "min-confidence") {
    known = parse_number(value, 0.0, 1.0, arguments_.least_confidence);
  } else if (name == "time-limit") {
    known = parse_number(value, 0.0, kMostSeconds, arguments_.time_limit);
  } else if (name == "prefer") {
    known = value == "ours" || value == "theirs";
    if (known) prefer_ = value == "theirs" ? Side::Theirs : Side::Ours;
  }
  if (!known) return refuse(fmt::format("{} cannot be \"{}\"", name, value));
  return {};
}

MatchOptions Session::options() const {
  MatchOptions options = cli::options_of(arguments_);
  options.waves = true;  // the report replays them
  options.progress = [this, began = Clock::now()](std::size_t matched, std::size_t most) {
    listener_.progress(matched, most);
    const double limit = arguments_.time_limit;
    return limit == 0 || std::chrono::duration<double>(Clock::now() - began).count() < limit;
  };
  return options;
}

Expected<PackedReport> Session::match() {
  const std::optional<MeshFile>&source = file(Slot::Source), &target = file(Slot::Target);
  if (!source || !target) return refuse("two meshes are needed");
  const bool exact = arguments_.algorithm == "exact";
  if (!exact && arguments_.time_limit != 0) {
    return refuse(fmt::format("a time limit is for the exact search; {} ends by itself", arguments_.algorithm));
  }
  listener_.stage("matching");
  result_ = quadmatch::match(source->mesh, target->mesh, options());
  listener_.stage("verifying");
  const Verdict verdict = verify(source->mesh, target->mesh, result_->match, 1);
  if (!verdict.sound()) {
    result_.reset();
    return refuse(fmt::format("internal error: the match found is not sound ({}); please report it",
                              verdict.faults.front().message));
  }
  listener_.stage("making the report");
  cli::MatchReport report = cli::report_match(source->mesh, target->mesh, *result_, false);
  report.source.path = source->path;
  report.target.path = target->path;
  const ReportText text{.title = fmt::format("{} and {}", source->path, target->path),
                        .program = "quadmatch " QUADMATCH_VERSION,
                        .figures = cli::figures_of(report),
                        .changes = unmatched_areas(source->mesh, target->mesh, result_->match)};
  PackedReport packed = pack_report(*source, *target, result_->match, text);
  for (Region& region : result_->match.regions) region.waves.clear();  // kept for the report alone
  return packed;
}

Expected<std::string> Session::match_file() const {
  if (!result_) return refuse("nothing has been matched yet");
  return format_match({side_of(*file(Slot::Source)), side_of(*file(Slot::Target)), result_->match,
                       cli::settings_of(arguments_), result_->optimality});
}

Expected<Product> Session::transferred(const std::string& name) const {
  if (!result_) return refuse("nothing has been matched yet");
  const Expected<Format> format = format_of(name);
  if (!format) return Unexpected(format.error());
  const MeshFile &source = *file(Slot::Source), &target = *file(Slot::Target);
  listener_.stage("carrying");
  Stopwatch stopwatch;
  cli::TransferSummary summary;
  summary.options.positions = !arguments_.no_positions;
  Expected<Transferred> result = transfer(source, target, result_->match, summary.options);
  if (!result) return Unexpected(std::move(result).error());
  if (result->report.matched_faces == 0) {
    const bool doubtful = !result->report.left_out.empty();
    return refuse(doubtful ? fmt::format("all that was found of {} is doubtful, so nothing is carried", source.path)
                           : fmt::format("nothing of {} was found in it, so nothing is carried", source.path),
                  target.path);
  }
  summary.times.matching = stopwatch.lap();
  Product product{format_mesh(result->file, *format), {}};
  summary.times.writing = stopwatch.lap();
  summary.source = source.path;
  summary.target = target.path;
  summary.source_faces = source.mesh.face_count();
  summary.report = std::move(result->report);
  summary.format = *format;
  summary.settings = program();
  summary.output = name;
  product.summary = cli::as_text(summary);
  return product;
}

Expected<Product> Session::merged(const std::string& name) const {
  const std::optional<MeshFile>&base = file(Slot::Source), &ours = file(Slot::Target), &theirs = file(Slot::Other);
  if (!base || !ours || !theirs) return refuse("three meshes are needed: a base and two edits of it");
  const Expected<Format> format = format_of(name);
  if (!format) return Unexpected(format.error());
  Stopwatch stopwatch;
  cli::MergeSummary summary;
  MatchOptions match_options;
  match_options.positions = !arguments_.no_positions;
  match_options.progress = [this](std::size_t matched, std::size_t most) {
    listener_.progress(matched, most);
    return true;
  };
  listener_.stage(fmt::format("matching {} and {}", base->path, ours->path));
  const Match to_ours = match_side(base->mesh, ours->mesh, match_options);
  listener_.stage(fmt::format("matching {} and {}", base->path, theirs->path));
  const Match to_theirs = match_side(base->mesh, theirs->mesh, match_options);
  summary.times.matching = stopwatch.lap();
  listener_.stage("merging");
  Expected<Merged> merged = merge(*base, *ours, *theirs, to_ours, to_theirs, {.prefer = prefer_});
  if (!merged) return Unexpected(std::move(merged).error());
  summary.times.merging = stopwatch.lap();
  Product product{format_mesh(merged->file, *format), {}};
  summary.times.writing = stopwatch.lap();
  summary.base = base->path;
  summary.ours = ours->path;
  summary.theirs = theirs->path;
  summary.base_faces = base->mesh.face_count();
  summary.ours_faces = ours->mesh.face_count();
  summary.theirs_faces = theirs->mesh.face_count();
  summary.prefer = prefer_;
  cli::count_origins(*merged, summary);
  summary.report = std::move(merged->report);
  summary.settings = program();
  summary.output = name;
  product.summary = cli::as_text(summary);
  return product;
}

}  // namespace quadmatch::page
