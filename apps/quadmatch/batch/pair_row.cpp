#include "pair_row.hpp"

#include "../json.hpp"

namespace quadmatch::cli {
namespace {

Json json_of(const PairRow& row) {
  Json json = Json::object();
  const auto add = [&json]<class Value>(const char* name, const Value& value) {
    if constexpr (requires { value.has_value(); }) {
      json[name] = value ? Json(*value) : Json(nullptr);
    } else {
      json[name] = value;
    }
  };
  visit_results(row, add);
  return json;
}

}  // namespace

std::string json_line(const PairRow& row) {
  return json_of(row).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool same_results(const PairRow& one, const PairRow& other) { return json_of(one) == json_of(other); }

bool same_job(const PairRow& one, const PairRow& other) {
  return one.source == other.source && one.target == other.target && one.options == other.options &&
         one.output == other.output;
}

}  // namespace quadmatch::cli
