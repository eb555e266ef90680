// make_instances: write pairs of meshes on which the paper's theorems can be tried.

#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "instances.hpp"

namespace {

using namespace quadmatch;

constexpr int kTrouble = 2;

constexpr const char* kGadgetsHelp =
    "For each graph of n vertices: NAME-source.obj, a ring of 8n quads, and NAME-target.obj, the graph as a mesh. 7n "
    "of "
    "the ring's quads match in one region exactly when the graph has a Hamiltonian cycle; where it has one, "
    "NAME-match.json is that match.\n\n"
    "Example:\n  make_instances gadgets build/gadgets --graph cube bridged\n"
    "  quadmatch match build/gadgets/cube-source.obj build/gadgets/cube-target.obj";

void add_gadgets(CLI::App& app, GadgetArguments& arguments) {
  CLI::App* command = app.add_subcommand("gadgets", "Meshes that ask for a Hamiltonian cycle (Theorem 3.1)");
  command->add_option("FOLDER", arguments.folder, "Where they go; made if it is missing")->required();
  command->add_option(
      "--graph", arguments.graphs,
      "Only these: k4, prism, cube, bridged, truncated-tetrahedron, three-branches, dodecahedron, tutte");
  command->add_flag("--adjacency", arguments.adjacency,
                    "Gadgets for a definition of a match that speaks of faces only; no match file is written");
  command->footer(kGadgetsHelp);
}

constexpr const char* kPlantedHelp =
    "For each seed: planted-SEED-source.obj, a grid, tube, torus or sphere, planted-SEED-target.obj, the same with a "
    "few "
    "places changed and renumbered, and planted-SEED-match.json, all that one region can hold of what is the same. The "
    "line printed tells the measured boundary complexity delta of the changed places and the width epsilon of what "
    "lies "
    "between them, in quads, and two anchors: one in the middle of a corridor, one anywhere.\n\n"
    "Example:\n  make_instances planted build/planted --first 1 --count 20";

void add_planted(CLI::App& app, PlantedArguments& arguments) {
  CLI::App* command = app.add_subcommand("planted", "Meshes with mismatches of known size and distance (Section 5)");
  command->add_option("FOLDER", arguments.folder, "Where they go; made if it is missing")->required();
  command->add_option("--first", arguments.first, "The first seed")->capture_default_str();
  command->add_option("--count", arguments.count, "How many seeds")->capture_default_str();
  command->footer(kPlantedHelp);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Write pairs of meshes on which the paper's theorems can be tried", "make_instances");
  app.require_subcommand(1);
  GadgetArguments gadgets;
  add_gadgets(app, gadgets);
  PlantedArguments planted;
  add_planted(app, planted);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kTrouble;
  }
  const Expected<void> made = app.got_subcommand("gadgets") ? make_gadgets(gadgets) : make_planted(planted);
  if (!made) {
    fmt::print(stderr, "make_instances: {}\n", made.error().describe());
    return kTrouble;
  }
  return 0;
}
