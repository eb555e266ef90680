#pragma once
/// In what two meshes that are not the same are different, in words.

#include <string>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>

#include "canonical/canonical_form.hpp"

namespace quadmatch {

/// Counts that an isomorphism, either way round, would keep: sizes, faces by corners, components by faces, seams, open
/// edges, vertices by valence. From the coarsest on; of each kind the first three that are different are named.
/// @return    one sentence each, without a full stop; none where all are the same.
/// @par Cost  O(#corners).
[[nodiscard]] std::vector<std::string> different_counts(const Mesh& source, const Mesh& target);

/// Clusters that have no equal in the other mesh, where all counts are the same.
/// @pre  the forms are different.
[[nodiscard]] std::vector<std::string> different_parts(const Mesh& source, const canonical::CanonicalForm& left,
                                                       const Mesh& target, const canonical::CanonicalForm& right);

}  // namespace quadmatch
