// The real program as the merge driver of the real git.

#include <doctest/doctest.h>

#include <quadmatch/analysis/isomorphism.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>

#include "program.hpp"
#include "use/merge_sites.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

/// A bear with edits at faces of the whole one.
PolygonSoup edited(const std::vector<std::pair<EditKind, FaceId>>& edits) {
  const PolygonSoup bear = shapes::bear().soup;
  const Mesh base = build(bear);
  Edited copy(bear);
  for (const auto& [kind, face] : edits) REQUIRE(copy.apply(base, {kind, base.first(face), {}}));
  return copy.soup();
}

constexpr FaceId kShoulder{40}, kBelly{2000};

/// A repository with a bear, and two branches that edited it.
void make_branches(const Folder& folder, const PolygonSoup& on_main, const PolygonSoup& on_topic) {
  folder.write("start.obj", shapes::bear().soup);
  folder.write("main.obj", on_main);
  folder.write("topic.obj", on_topic);
  const Outcome made = folder.shell(R"(set -e
    git init -q -b main repository
    cd repository
    git config merge.quadmatch.name "three-way merge of meshes"
    git config merge.quadmatch.driver "'$QUADMATCH' merge %O %A %B -o %A --as %P --quiet"
    echo '*.obj merge=quadmatch' > .gitattributes
    cp ../start.obj bear.obj
    git add . && git commit -qm start
    git checkout -qb topic && cp ../topic.obj bear.obj && git commit -qam topic
    git checkout -q main && cp ../main.obj bear.obj && git commit -qam main)");
  INFO(made.err);
  REQUIRE(made.status == 0);
}

bool is_same(const Folder& folder, std::string_view path, const PolygonSoup& truth) {
  const auto file = read_mesh(folder.path(path));
  REQUIRE(file.has_value());
  const Expected<Mesh> mesh = Mesh::build(truth);
  REQUIRE(mesh.has_value());
  return find_isomorphism(file->mesh, *mesh, IsomorphismKind::Preserving).isomorphism.has_value();
}

}  // namespace

TEST_CASE("git merges two branches that edited one OBJ at different places, by quadmatch as its merge driver") {
  const Folder folder;
  make_branches(folder, edited({{EditKind::Extrude, kShoulder}}),
                shapes::renumbered(edited({{EditKind::Delete, kBelly}}), 3).soup);
  const Outcome merged = folder.shell("cd repository && git merge -q --no-edit topic && git status --porcelain");
  INFO(merged.err);
  CHECK(merged.status == 0);
  CHECK_FALSE(contains(merged.out, "CONFLICT"));
  CHECK(is_same(folder, "repository/bear.obj", edited({{EditKind::Extrude, kShoulder}, {EditKind::Delete, kBelly}})));
  CHECK(folder.shell("cd repository && git log --oneline --merges | wc -l").out == "1\n");
}

TEST_CASE("git is told of edits that meet: the file is unmerged, and holds our side there") {
  const Folder folder;
  make_branches(folder, edited({{EditKind::Extrude, kShoulder}}),
                edited({{EditKind::Delete, kShoulder}, {EditKind::Delete, kBelly}}));
  const Outcome merged = folder.shell("cd repository && git merge -q --no-edit topic; echo $?; git status --porcelain");
  CHECK(contains(merged.out, "CONFLICT"));
  CHECK(contains(merged.out, "\n1\n"));
  CHECK(contains(merged.out, "UU bear.obj"));
  CHECK(is_same(folder, "repository/bear.obj", edited({{EditKind::Extrude, kShoulder}, {EditKind::Delete, kBelly}})));
}
