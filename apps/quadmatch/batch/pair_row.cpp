#include "pair_row.hpp"

#include "../json.hpp"

namespace quadmatch::cli {
namespace {

std::string text_of(const std::string& value) {
  return Json(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}
std::string text_of(double value) { return Json(value).dump(); }
std::string text_of(std::uint64_t value) { return std::to_string(value); }
std::string text_of(std::uint32_t value) { return std::to_string(value); }
template <class Value>
std::string text_of(const std::optional<Value>& value) {
  return value ? text_of(*value) : "null";
}

}  // namespace

// Field by field: one JSON object for each of a million rows would take longer than to read them.
std::string json_line(const PairRow& row) {
  std::string line;
  visit_results(row, [&line](const char* name, const auto& value) {
    line += line.empty() ? '{' : ',';
    line.append(1, '"').append(name).append("\":").append(text_of(value));
  });
  return line + "}\n";
}

bool same_results(const PairRow& one, const PairRow& other) { return json_line(one) == json_line(other); }

bool same_job(const PairRow& one, const PairRow& other) {
  return one.source == other.source && one.target == other.target && one.options == other.options &&
         one.output == other.output;
}

}  // namespace quadmatch::cli
