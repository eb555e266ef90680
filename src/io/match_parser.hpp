#pragma once
/// The JSON of a match file, by way of the JSON library.

#include <string>
#include <string_view>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::io {

inline constexpr std::string_view kMatchFormat = "quadmatch.match/1";

/// What to do about most of what can be wrong with a match file; closes a message.
inline constexpr const char* kRematch = "match the meshes again";

/// Read the fields of a match file. Whether its indices fit the counts it states is left to the caller.
/// @par Errors  Syntax, BadNumber, Truncated, with the line but without a path.
[[nodiscard]] Expected<MatchFile> parse_match_json(std::string_view bytes);

/// A text in quotes, escaped; bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string json_text(const std::string& text);

}  // namespace quadmatch::io
