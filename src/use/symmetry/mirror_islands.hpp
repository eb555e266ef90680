#pragma once
/// Parts that an edit lifted on one side of a mirror, or cut off by rows of new quads.

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/mesh/mesh.hpp>

#include "mirror_map.hpp"

namespace quadmatch::use {

/// Beyond the rim of what is laid, a row or two of quads on one side may be new; what lies beyond them is then opposite
/// what lies at the rim on the other side. All around the rim of a lifted patch such hops say the same, so the map of
/// free faces that most hops agree on is laid, then the next. What was laid about it stays where it does not
/// contradict. Where no hop over new rows finds an island, and where more is free than an edit leaves, nothing changes.
/// @par Cost  O(#faces), and a bounded number of times that where something was lifted.
void lay_islands(const Mesh& mesh, const PerFan<VertexCode>& codes, MirrorMap& map);

}  // namespace quadmatch::use
