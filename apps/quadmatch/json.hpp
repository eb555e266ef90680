#pragma once
/// JSON for machines: fields in the order they are written, bytes that are no UTF-8 replaced.

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

namespace quadmatch::cli {

using Json = nlohmann::ordered_json;

/// The numbers of elements.
template <class Ids>
[[nodiscard]] Json numbers(const Ids& ids) {
  Json list = Json::array();
  for (const auto id : ids) list.push_back(id.value);
  return list;
}

/// To the microsecond.
[[nodiscard]] inline double rounded(double milliseconds) { return std::round(milliseconds * 1000.0) / 1000.0; }

[[nodiscard]] inline std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace quadmatch::cli
