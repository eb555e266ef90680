#pragma once
/// What make_instances writes, kind by kind. Each prints one line of JSON for each pair that it writes.

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

}  // namespace quadmatch
