#pragma once
/// JSON for machines: fields in the order they are written, bytes that are no UTF-8 replaced.

#include <string>

#include <nlohmann/json.hpp>

namespace quadmatch::cli {

using Json = nlohmann::ordered_json;

[[nodiscard]] inline std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace quadmatch::cli
