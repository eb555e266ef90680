#include <quadmatch/analysis/connectivity_hash.hpp>

#include <fmt/format.h>

#include "canonical/canonical_form.hpp"
#include "sha1.hpp"

namespace quadmatch {
namespace {

/// The heading, then numbers of four bytes: unused vertices, clusters, and for each cluster its faces and all it is.
/// From these the mesh can be built anew, so no two different meshes are digested alike.
Digest digest_of(const canonical::CanonicalForm& form) {
  Sha1 sha1;
  sha1.add("quadmatch.connectivity/1\n");
  sha1.add(form.unused_vertices);
  sha1.add(static_cast<std::uint32_t>(form.clusters.size()));
  for (const canonical::CanonicalForm::Cluster& cluster : form.clusters) {
    sha1.add(cluster.face_count);
    for (const std::uint32_t number : form.numbers_of(cluster)) sha1.add(number);
  }
  return sha1.finish();
}

}  // namespace

std::string Digest::hex() const {
  std::string text;
  for (const std::uint8_t byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

ConnectivityHash connectivity_hash(const Mesh& mesh) {
  return {digest_of(canonical::canonical_form(mesh)), digest_of(canonical::canonical_form(mesh.mirrored()))};
}

}  // namespace quadmatch
