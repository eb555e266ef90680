// The guarantee of §5: meshes that are the same but for planted mismatches.

#include <fmt/format.h>

#include <quadmatch/shapes/planted.hpp>

#include "instances.hpp"
#include "pair_files.hpp"

namespace quadmatch {
namespace {

/// As `quadmatch match --anchor` takes it.
std::string anchor_text(const FacePair& pair) {
  return fmt::format("{}:0={}:{}", pair.source.value, pair.target.value, pair.rotation);
}

}  // namespace

Expected<void> make_planted(const PlantedArguments& arguments) {
  for (std::uint64_t seed = arguments.first; seed < arguments.first + arguments.count; ++seed) {
    const Expected<shapes::Planted> planted = shapes::plant_mismatches(shapes::random_planted_options(seed));
    if (!planted) {
      fmt::print(stderr, "make_instances: seed {}: {}\n", seed, planted.error().message);
      continue;
    }
    const std::string name = fmt::format("planted-{}", seed);
    const Pair pair{planted->source, planted->target, planted->region};
    if (Expected<void> written = write_pair(arguments.folder, name, pair); !written) return written;
    fmt::print(
        "{{\"name\": \"{}\", \"source\": {}, \"target\": {}, \"planted\": {}, \"delta\": {}, \"epsilon\": {}, "
        "\"anchor\": \"{}\", \"anywhere\": \"{}\", \"what\": \"{}\"}}\n",
        name, planted->source.corners.size() / 4, planted->target.corners.size() / 4, planted->region.size(),
        planted->delta, planted->epsilon, anchor_text(planted->anchor), anchor_text(planted->anywhere),
        planted->description);
  }
  return {};
}

}  // namespace quadmatch
