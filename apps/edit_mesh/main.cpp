// edit_mesh SOURCE TARGET EDIT[:SIZE]...: edit a mesh as modelers do, at random places, and keep what is still the
// same.

#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/shapes/random_edit.hpp>

#include "truth_file.hpp"

namespace {

using namespace quadmatch;

constexpr int kTrouble = 2;

struct Arguments {
  std::string source, target, truth;
  std::vector<std::string> edits;
  std::uint64_t seed = 0;
};

int complain(const Error& error) {
  fmt::print(stderr, "edit_mesh: {}\n", error.describe());
  return kTrouble;
}

PolygonSoup soup_of(const Mesh& mesh) {
  PolygonSoup soup;
  soup.vertex_count = mesh.vertex_count();
  soup.positions.assign(mesh.positions().begin(), mesh.positions().end());
  soup.corners.assign(mesh.corners().begin(), mesh.corners().end());
  if (mesh.all_quads()) return soup;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) soup.face_starts.push_back(mesh.first(FaceId(f)).value);
  soup.face_starts.push_back(mesh.halfedge_count());
  return soup;
}

/// A mesh on itself.
std::vector<FacePair> identity(const Mesh& mesh) {
  std::vector<FacePair> pairs;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) pairs.push_back({FaceId(f), FaceId(f), 0});
  return pairs;
}

Expected<shapes::Edit> edited(const Mesh& mesh, const Arguments& arguments) {
  shapes::Random random(arguments.seed);
  shapes::Edit all{soup_of(mesh), identity(mesh)};
  for (const std::string& text : arguments.edits) {
    const Expected<shapes::RandomEdit> edit = shapes::parse_random_edit(text);
    if (!edit) return Unexpected(edit.error());
    Expected<shapes::Edit> next = shapes::edit_at_random(all.soup, *edit, random);
    if (!next) return Unexpected(Error{next.error().code, text + " does not fit: " + next.error().message});
    all.truth = shapes::chained(all.truth, next->truth, next->soup);
    all.soup = std::move(next->soup);
  }
  return all;
}

int edit(const Arguments& arguments) {
  const Expected<MeshFile> source = read_mesh(arguments.source);
  if (!source) return complain(source.error());
  Expected<shapes::Edit> result = edited(source->mesh, arguments);
  if (!result) return complain(result.error());
  Expected<Mesh> mesh = Mesh::build(std::move(result->soup));
  if (!mesh) return complain(mesh.error());
  const std::uint32_t faces = mesh->face_count();
  if (const auto written = write_mesh(arguments.target, {.mesh = *std::move(mesh)}); !written) {
    return complain(written.error());
  }
  if (!arguments.truth.empty() && !write_truth(arguments.truth, result->truth)) {
    fmt::print(stderr, "edit_mesh: {}: cannot be written\n", arguments.truth);
    return kTrouble;
  }
  fmt::print(stderr, "{} faces, of which {} survive\n", faces, result->truth.size());
  return 0;
}

std::string footer() {
  std::string text = "Edits, with the size unless another is given:\n";
  for (const shapes::RandomEditKind& kind : shapes::random_edit_kinds()) {
    text += fmt::format("  {:14}{}\n", fmt::format("{}:{}", kind.name, kind.size), kind.description);
  }
  return text +
         "\nThe same arguments make the same files on every machine.\n\n"
         "Example:\n  edit_mesh bear.obj copy.obj --truth truth.json --seed 7 loop:2 rip twist renumber";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Edit a mesh as modelers do, at random places, and keep which faces are still the same", "edit_mesh");
  Arguments arguments;
  app.add_option("SOURCE", arguments.source, "Mesh to edit; - reads standard input")->required();
  app.add_option("TARGET", arguments.target, "Mesh to write, positions and faces only")->required();
  app.add_option("EDIT", arguments.edits, "NAME or NAME:SIZE, made one after the other")->required();
  app.add_option("--truth", arguments.truth, "Also write which faces survive, and where they are now (JSON)");
  app.add_option("--seed", arguments.seed, "Other seeds, other places")->capture_default_str();
  app.footer(footer());
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kTrouble;
  }
  return edit(arguments);
}
