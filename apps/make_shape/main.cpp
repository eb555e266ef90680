// make_shape NAME[:SIZE[,SIZE]] OUT: write one of the shapes that tests and benchmarks are made of.

#include <charconv>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/shapes/figures.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "truth_file.hpp"

namespace {

using namespace quadmatch;

constexpr int kTrouble = 2;

using Sizes = std::vector<std::uint32_t>;

struct Shape {
  const char* name;
  const char* description;
  Sizes least;  ///< of each size it takes
  PolygonSoup (*make)(const Sizes& sizes);
};

const Shape kShapes[] = {
    {"grid", "M by N quads in the plane", {1, 1}, [](const Sizes& s) { return shapes::grid(s[0], s[1]); }},
    {"cylinder",
     "a tube, M quads around, N along",
     {3, 1},
     [](const Sizes& s) { return shapes::cylinder(s[0], s[1]); }},
    {"star",
     "N grids of K by K quads around a vertex",
     {3, 1},
     [](const Sizes& s) { return shapes::star(s[0], s[1]); }},
    {"torus", "M quads around, N along", {3, 3}, [](const Sizes& s) { return shapes::torus(s[0], s[1]); }},
    {"sphere", "a round cube of K by K quads a side", {1}, [](const Sizes& s) { return shapes::sphere(s[0]); }},
    {"prism", "N quads between two N-gons", {3}, [](const Sizes& s) { return shapes::prism(s[0]); }},
    {"grating", "a plate with M by N holes", {1, 1}, [](const Sizes& s) { return shapes::grating(s[0], s[1]); }},
    {"dog_toy", "genus G, tubes of N rings", {1, 2}, [](const Sizes& s) { return shapes::dog_toy(s[0], s[1]); }},
    {"cubes", "N of them, apart from each other", {1}, [](const Sizes& s) { return shapes::many_components(s[0]); }},
    {"fig_4_1", "the mesh of Fig. 4.1", {}, [](const Sizes&) { return shapes::fig_4_1().soup; }},
    {"fig_4_2",
     "that of Fig. 4.2, which has a truth: its faces in Fig. 4.1",
     {},
     [](const Sizes&) { return shapes::fig_4_2().soup; }},
};

struct Arguments {
  std::string shape, output, truth;
};

int complain(const std::string& what) {
  fmt::print(stderr, "make_shape: {}\n", what);
  return kTrouble;
}

/// The numbers after the colon; false where one is none.
bool read_sizes(std::string_view text, Sizes& sizes) {
  while (!text.empty()) {
    std::uint32_t size = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), size);
    if (problem != std::errc()) return false;
    sizes.push_back(size);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.size() == 1 || (!text.empty() && text.front() != ',')) return false;
    if (!text.empty()) text.remove_prefix(1);
  }
  return true;
}

bool large_enough(const Sizes& sizes, const Sizes& least) {
  if (sizes.size() != least.size()) return false;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (sizes[k] < least[k]) return false;
  }
  return true;
}

/// As it is typed: name:least,least.
std::string usage_of(const Shape& shape) {
  return shape.least.empty() ? shape.name : fmt::format("{}:{}", shape.name, fmt::join(shape.least, ","));
}

int write_shape(const Shape& shape, const Sizes& sizes, const Arguments& arguments) {
  Expected<Mesh> mesh = Mesh::build(shape.make(sizes));
  if (!mesh) return complain(mesh.error().describe());
  const std::uint32_t faces = mesh->face_count();
  if (const auto written = write_mesh(arguments.output, {.mesh = *std::move(mesh)}); !written) {
    return complain(written.error().describe());
  }
  if (!arguments.truth.empty() && !write_truth(arguments.truth, shapes::fig_4_2().truth)) {
    return complain(arguments.truth + ": cannot be written");
  }
  fmt::print(stderr, "{} faces\n", faces);
  return 0;
}

int make(const Arguments& arguments) {
  const std::size_t colon = arguments.shape.find(':');
  const std::string name = arguments.shape.substr(0, colon);
  for (const Shape& shape : kShapes) {
    if (name != shape.name) continue;
    Sizes sizes;
    const bool read =
        colon == std::string::npos || read_sizes(std::string_view(arguments.shape).substr(colon + 1), sizes);
    if (!read || !large_enough(sizes, shape.least)) {
      return complain(fmt::format("{}: the least there is is {}", arguments.shape, usage_of(shape)));
    }
    if (!arguments.truth.empty() && name != "fig_4_2")
      return complain(name + " is no copy of anything: it has no truth");
    return write_shape(shape, sizes, arguments);
  }
  return complain(fmt::format("there is no shape named {}; see --help", name));
}

std::string footer() {
  std::string text = "Shapes, with the least sizes they take:\n";
  for (const Shape& shape : kShapes) text += fmt::format("  {:14}{}\n", usage_of(shape), shape.description);
  return text + "\nExample:\n  make_shape torus:12,8 torus.obj";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Write one of the shapes that tests and benchmarks are made of", "make_shape");
  Arguments arguments;
  app.add_option("SHAPE", arguments.shape, "NAME or NAME:SIZE,SIZE")->required();
  app.add_option("OUT", arguments.output, "Mesh to write")->required();
  app.add_option("--truth", arguments.truth, "Also write which faces of Fig. 4.1 are where in Fig. 4.2 (JSON)");
  app.footer(footer());
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kTrouble;
  }
  return make(arguments);
}
