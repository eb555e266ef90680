#pragma once
/// What make_instances writes, kind by kind. Each prints one line of JSON for each pair that it writes.

#include <cstdint>
#include <string>
#include <vector>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch {

struct GadgetArguments {
  std::string folder;
  /// Names of graphs; empty means all.
  std::vector<std::string> graphs;
  /// Gadgets made for §3 to the letter.
  bool adjacency = false;
};

[[nodiscard]] Expected<void> make_gadgets(const GadgetArguments& arguments);

struct PlantedArguments {
  std::string folder;
  /// Seeds first ... first + count - 1; those for which there is no room are passed over.
  std::uint64_t first = 1;
  std::uint32_t count = 10;
};

[[nodiscard]] Expected<void> make_planted(const PlantedArguments& arguments);

}  // namespace quadmatch
