#include "examples.hpp"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/catmull_clark.hpp>
#include <quadmatch/shapes/figures.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>
#include <quadmatch/shapes/zoo.hpp>

namespace quadmatch {
namespace {

constexpr std::uint64_t kSeed = 2009;

constexpr shapes::BearPose kWaving = {.left_arm = 0.20,
                                      .right_arm = -0.04,
                                      .left_leg = 0.07,
                                      .right_leg = -0.07,
                                      .head_turn = 0.08,
                                      .head_tilt = -0.03,
                                      .body_bend = -0.02};
constexpr shapes::BearPose kReaching = {.left_arm = 0.05,
                                        .right_arm = 0.22,
                                        .left_leg = -0.05,
                                        .right_leg = 0.09,
                                        .head_turn = -0.06,
                                        .head_tilt = 0.03,
                                        .body_bend = 0.03};

/// Adding zero turns -0 into 0.
double rounded(double value) { return std::round(value * 1e5) / 1e5 + 0.0; }

/// A mesh alone. Every soup that comes here is sound, so that building it cannot fail.
Example bare(std::string name, PolygonSoup soup, std::string description) {
  for (Point& point : soup.positions) {
    for (double& coordinate : point) coordinate = rounded(coordinate);
  }
  MeshFile file{.mesh = *Mesh::build(std::move(soup)), .format = Format::Obj, .path = name};
  file.comments = {std::move(description), "Made by: build/release/make_examples examples"};
  file.face_records = {{0, "o", name.substr(0, name.find('.'))}};
  return {std::move(name), std::move(file)};
}

void add_parts(MeshFile& file, const shapes::Model& model) {
  std::string material;
  for (const shapes::ModelPart& part : model.parts) {
    file.face_records.push_back({part.first_face, "g", part.name});
    if (part.material != material) file.face_records.push_back({part.first_face, "usemtl", part.material});
    material = part.material;
  }
}

/// Corners at the same place of the texture share a `vt` record, in the order of their first use.
void add_coordinates(MeshFile& file, const shapes::Model& model) {
  std::map<shapes::TextureCoordinate, std::uint32_t> index_of;
  IndexedAttribute pool;
  pool.components = 2;
  for (const shapes::TextureCoordinate& coordinate : model.coordinates) {
    const shapes::TextureCoordinate place = {rounded(coordinate[0]), rounded(coordinate[1])};
    const auto [entry, is_new] = index_of.try_emplace(place, static_cast<std::uint32_t>(index_of.size()));
    if (is_new) pool.values.insert(pool.values.end(), place.begin(), place.end());
    pool.corner_index.push_back(entry->second);
  }
  file.texture_coordinates = std::move(pool);
}

/// A mesh with groups, materials and texture coordinates.
Example textured(std::string name, const shapes::Model& model, std::string description) {
  Example example = bare(std::move(name), model.soup, std::move(description));
  add_parts(example.file, model);
  add_coordinates(example.file, model);
  return example;
}

/// As after an export from another program: another order of everything, and nothing but the mesh.
Example exported(std::string name, const shapes::Model& model, std::string description) {
  return bare(std::move(name), shapes::renumbered(model.soup, kSeed).soup, std::move(description));
}

}  // namespace

std::vector<Example> make_examples() {
  using namespace shapes;
  std::vector<Example> examples;
  examples.push_back(textured("bear.obj", bear(), "A bear, with groups, materials and texture coordinates"));
  const Model posed = bear({.pose = kReaching});
  Example animated = bare("bear_posed.obj", posed.soup, "The bear in another pose, its faces in the same order");
  add_parts(animated.file, posed);
  examples.push_back(std::move(animated));
  examples.push_back(exported("bear_no_ears_posed.obj", bear({.ears = false, .pose = kWaving}),
                              "The bear without ears, in another pose and another order"));
  examples.push_back(textured("shirt_long.obj", shirt(Sleeves::Long),
                              "A shirt with long sleeves, with groups, materials and texture coordinates"));
  examples.push_back(
      exported("shirt_short.obj", shirt(Sleeves::Short), "The shirt with short sleeves, in another order"));
  examples.push_back(bare("fig_4_1.obj", fig_4_1().soup, "The mesh of Fig. 4.1: five extraordinary vertices"));
  examples.push_back(
      bare("fig_4_2.obj", fig_4_2().soup, "The mesh of Fig. 4.2: three quads of Fig. 4.1 squeezed into edges"));
  examples.push_back(bare("dog_toy.obj", catmull_clark(dog_toy(16, 6)), "The dog toy of Fig. 2.1, of genus 16"));
  return examples;
}

}  // namespace quadmatch
