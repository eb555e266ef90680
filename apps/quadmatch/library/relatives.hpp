#pragma once
/// Which meshes of a library have most in common with a mesh, by their signatures alone.

#include <cstdint>
#include <vector>

#include <quadmatch/analysis/signature.hpp>
#include <quadmatch/mesh/expected.hpp>

#include "library_store.hpp"

namespace quadmatch::cli {

/// Values that a mesh is asked for with: more than a library keeps of each of its meshes, so that one of an eighth of
/// the size of this mesh still has all its values asked for.
constexpr std::uint32_t kAskedValues = 1024;

struct Relative {
  LibraryMesh mesh;
  /// Estimates of how many elements of both meshes together are in both, and of how many of this mesh and of the other
  /// are in the other one; 0 to 1.
  double common = 0, of_this = 0, of_other = 0;
  /// What the order goes by: what is common, each element weighing more the fewer meshes have it.
  double weight = 0;
};

/// The meshes that share most, best first; ties go to the one nearer in size, then to the lesser path. Where fewer than
/// `most` share anything, those nearest in size follow.
///
/// @param faces  of the mesh, which breaks ties.
/// @param asked  its signature, of kAskedValues values.
/// @par Cost     O(asked values * log(library)), whatever the size of the library: of a value that very many meshes
/// have,
///               only the first of them are looked at.
[[nodiscard]] Expected<std::vector<Relative>> find_relatives(LibraryStore& store, const Signature& asked,
                                                             std::uint32_t faces, std::uint32_t most);

}  // namespace quadmatch::cli
