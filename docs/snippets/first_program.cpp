#include <cstdio>

#include <quadmatch/quadmatch.hpp>

int main() {
  const auto a = quadmatch::read_mesh("examples/bear.obj");
  const auto b = quadmatch::read_mesh("examples/bear_no_ears_posed.obj");
  if (!a || !b) return 2;  // a.error().describe() says why, in one line
  const quadmatch::Match match = quadmatch::match(a->mesh, b->mesh).match;
  std::printf("%zu of %u faces matched\n", match.matched_faces(), a->mesh.face_count());
}
