#pragma once
/// Fill::Smooth for data of corners: new faces between matched ones get texture coordinates that go on from there.

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::use {

/// Interpolate the attribute over unmatched faces. A node is a fan of unmatched corners that hang together across
/// edges; beside a matched face it has that face's value. Where the faces at the two ends of a fan disagree, a seam
/// enters: the shortest way to where another does is cut, no node reaches across a cut, and values along it depend on
/// its two ends alone; where there is none, the fan alone is cut in the middle.
///
/// @param matched    for each face whether it has the values it should have.
/// @param attribute  by corners of `mesh`; unmatched corners have no index. Those that hang together with a matched
/// face
///                   get one; new tuples go to the end of the pool.
/// @par Cost         as `interpolate` over the unmatched corners.
void fill_corners(const Mesh& mesh, const PerFace<FaceId>& matched, IndexedAttribute& attribute);

}  // namespace quadmatch::use
