#pragma once
/// `--anchor`: places that the user knows to be the same.

#include <string>
#include <vector>

#include <quadmatch/match/matcher.hpp>
#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::cli {

/// A mesh and what messages call it.
struct NamedMesh {
  const Mesh& mesh;
  std::string name;
};

/// What an anchor names, for one way round. All numbers count from 0.
///
///   F:C=G:D   corner C of face F lies on corner D of face G
///   A-B=C-D   the edge from vertex A to B lies on the edge from C to D, and with it the faces to their left, or to
///             their right where one of the edges has no face there
///   A=B       vertex A lies on vertex B: every alignment of the faces around them, those first in which more
///             neighbours look alike
///
/// @param orientation  how the target is laid; an edge's left becomes the other edge's right when reversing.
/// @return             seeds to try in this order, at least one; each has passed check_anchor.
/// @par Errors         BadArgument, naming the option and the element.
/// @par Cost           O(#corners + d^2 log d) for vertices of d faces.
[[nodiscard]] Expected<std::vector<UserAnchor>> parse_anchor(const std::string& text, const NamedMesh& source,
                                                             const NamedMesh& target, Orientation orientation);

}  // namespace quadmatch::cli
