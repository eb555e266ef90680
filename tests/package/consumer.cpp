// Calls something of every layer, so that a missing library does not link.

#include <cstdio>

#include <quadmatch/quadmatch.hpp>

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const auto file = quadmatch::read_mesh(arguments[1]);
  if (!file) return 2;
  const quadmatch::Mesh& mesh = file->mesh;
  const quadmatch::MatchResult result = quadmatch::match(mesh, mesh);
  const bool sound = quadmatch::verify(mesh, mesh, result.match).sound();
  const quadmatch::Signature signature = quadmatch::signature_of(mesh, 16);
  const auto difference = quadmatch::diff(mesh, mesh, result.match);
  if (!difference) return 1;
  std::printf("%zu of %u faces, %s, %zu values, %zu changes\n", result.match.matched_faces(), mesh.face_count(),
              sound ? "sound" : "unsound", signature.values.size(), difference->changes.size());
  return sound && result.match.matched_faces() == mesh.face_count() ? 0 : 1;
}
