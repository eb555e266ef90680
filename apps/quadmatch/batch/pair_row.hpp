#pragma once
/// What is kept of a pair: a row of the database, a line of the JSON Lines.

#include <cstdint>
#include <optional>
#include <string>

namespace quadmatch::cli {

namespace status {
constexpr const char* kMatched = "matched";      ///< in whole or in part
constexpr const char* kUnmatched = "unmatched";  ///< nothing of it is the same
constexpr const char* kFailed = "failed";        ///< `error` says why
constexpr const char* kRefused = "refused";      ///< it needs more memory than allowed
constexpr const char* kDuplicate = "duplicate";  ///< of an earlier job, named by `error`
}  // namespace status

struct PairRow {
  std::uint32_t job = 0;   ///< row of the job list below its header, from 1
  std::uint64_t line = 0;  ///< of the job list, from 1
  std::string name = {}, source = {}, target = {}, options = {}, output = {};
  std::string status = {};
  std::optional<std::string> error = {};    ///< one sentence
  std::optional<std::string> remarks = {};  ///< what is dirty, or had to be guessed
  std::optional<std::uint64_t> estimated_bytes = {};
  std::optional<std::uint32_t> source_vertices = {}, source_faces = {}, target_vertices = {}, target_faces = {};
  std::optional<std::uint32_t> matched_faces = {}, matched_vertices = {}, regions = {}, ambiguous_faces = {};
  std::optional<std::uint32_t> source_unmatched_areas = {}, target_unmatched_areas = {};
  std::optional<double> confidence = {};                 ///< of all regions together; none where nothing is matched
  std::optional<std::uint32_t> proved = {}, bound = {};  ///< of an exact search
  std::optional<std::string> answer = {};                ///< to --at-least: yes, no, unknown
  std::optional<double> reading_ms = {}, matching_ms = {}, verifying_ms = {}, writing_ms = {};

  /// Has the pair been looked at to the end?
  [[nodiscard]] bool done() const { return status == status::kMatched || status == status::kUnmatched; }
};

/// Visit the columns that are the same on every run, in order: `visit(name, value)`.
template <class Row, class Visit>
void visit_results(Row& row, Visit&& visit) {
  visit("job", row.job);
  visit("line", row.line);
  visit("name", row.name);
  visit("source", row.source);
  visit("target", row.target);
  visit("options", row.options);
  visit("output", row.output);
  visit("status", row.status);
  visit("error", row.error);
  visit("remarks", row.remarks);
  visit("estimated_bytes", row.estimated_bytes);
  visit("source_vertices", row.source_vertices);
  visit("source_faces", row.source_faces);
  visit("target_vertices", row.target_vertices);
  visit("target_faces", row.target_faces);
  visit("matched_faces", row.matched_faces);
  visit("matched_vertices", row.matched_vertices);
  visit("regions", row.regions);
  visit("ambiguous_faces", row.ambiguous_faces);
  visit("source_unmatched_areas", row.source_unmatched_areas);
  visit("target_unmatched_areas", row.target_unmatched_areas);
  visit("confidence", row.confidence);
  visit("proved", row.proved);
  visit("bound", row.bound);
  visit("answer", row.answer);
}

/// And those that are not: times, in milliseconds.
template <class Row, class Visit>
void visit_times(Row& row, Visit&& visit) {
  visit("reading_ms", row.reading_ms);
  visit("matching_ms", row.matching_ms);
  visit("verifying_ms", row.verifying_ms);
  visit("writing_ms", row.writing_ms);
}

template <class Row, class Visit>
void visit_columns(Row& row, Visit&& visit) {
  visit_results(row, visit);
  visit_times(row, visit);
}

/// The results as one line of JSON, its end included; what there is not is null. Bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string json_line(const PairRow& row);

/// Do both say the same, whenever and however fast they were made?
[[nodiscard]] bool same_results(const PairRow& one, const PairRow& other);

/// Do both speak of the same pair with the same options?
[[nodiscard]] bool same_job(const PairRow& one, const PairRow& other);

}  // namespace quadmatch::cli
