#pragma once
/// How a pair is to be matched, as options say it, and the matching: what `match` and `batch` have in common.

#include <functional>
#include <string>

#include <CLI/CLI.hpp>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/match/matcher.hpp>

#include "anchor_option.hpp"
#include "match_arguments.hpp"

namespace quadmatch::cli {

void add_matching_options(CLI::App& verb, MatchingArguments& arguments);

/// Do the options of the exact search go together with the rest? @par Errors  BadArgument.
[[nodiscard]] Expected<void> check_matching(const MatchingArguments& arguments);

/// The options that are not as they are by default, in a fixed order: "--algorithm=exact --time-limit=10".
[[nodiscard]] std::string options_text(const MatchingArguments& arguments);

/// Match as the arguments say.
///
/// @param waves     keep how it grew.
/// @param progress  called now and then with faces matched and the most there can be; may be empty.
/// @par Errors      BadArgument for an anchor that does not fit the meshes.
[[nodiscard]] Expected<MatchResult> match_as_asked(const MatchingArguments& arguments, const NamedMesh& source,
                                                   const NamedMesh& target, bool waves,
                                                   const std::function<void(std::size_t, std::size_t)>& progress);

/// No match leaves this program that the definition does not allow. @par Errors  Syntax, an internal error.
[[nodiscard]] Expected<void> check_sound(const Mesh& source, const Mesh& target, const Match& match);

/// How a match file names a mesh.
[[nodiscard]] MatchSide side_of(const MeshFile& file);

}  // namespace quadmatch::cli
