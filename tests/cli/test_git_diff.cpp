// Against the real git, in a folder of its own.

#include <doctest/doctest.h>

#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

/// A repository whose .obj files are compared by quadmatch.
class Repository {
 public:
  Repository() {
    git({"init", "--quiet"});
    git({"config", "user.name", "somebody"});
    git({"config", "user.email", "somebody@example.org"});
    folder.write(".gitattributes", "*.obj diff=quadmatch\n");
  }

  Outcome git(const std::vector<std::string>& arguments) const {
    const Outcome outcome = folder.run_git(arguments);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 0);
    return outcome;
  }

  void commit(const char* what) const {
    git({"add", "-A"});
    git({"commit", "--quiet", "-m", what});
  }

  void call_for_diff(const std::string& options = {}) const {
    git({"config", "diff.quadmatch.command", "'" QUADMATCH_PROGRAM "' diff " + options + "--git"});
  }

  Folder folder;
};

PolygonSoup shirt() { return shapes::shirt(shapes::Sleeves::Short).soup; }

PolygonSoup cut_shirt() {
  const Expected<shapes::Edit> edit = shapes::delete_patch(shirt(), FaceId(600), 12);
  REQUIRE(edit.has_value());
  return shapes::renumbered(edit->soup, 4).soup;
}

}  // namespace

TEST_CASE("git diff names the changes of a mesh by its name in the repository") {
  const Repository repository;
  repository.call_for_diff();
  repository.folder.write("shirt.obj", shirt());
  repository.folder.write("notes.txt", "one\n");
  repository.commit("A shirt");
  repository.folder.write("shirt.obj", cut_shirt());
  repository.folder.write("notes.txt", "two\n");
  const Outcome outcome = repository.git({"diff"});
  CHECK(contains(outcome.out, "quadmatch diff shirt.obj\ndifferent\n"));
  CHECK(contains(outcome.out, "  source    a/shirt.obj: 1,432 faces"));
  CHECK(contains(outcome.out, "  target    b/shirt.obj: 1,420 faces"));
  CHECK(contains(outcome.out, "  deletion  12 faces removed"));
  CHECK(contains(outcome.out, "+two\n"));
  repository.commit("A hole");
  CHECK(contains(repository.git({"log", "-p", "--ext-diff", "-1"}).out, "  deletion  12 faces removed"));
}

TEST_CASE("git diff tells of new, deleted and renamed meshes, and goes on after a file that is none") {
  const Repository repository;
  repository.call_for_diff("--stat ");
  repository.folder.write("a_broken.obj", "f 1 2 3\n");
  repository.folder.write("old.obj", shirt());
  repository.folder.write("with space.obj", shirt());
  repository.commit("Three");
  repository.folder.write("a_broken.obj", "f 1 2 4\n");
  repository.git({"rm", "--quiet", "old.obj"});
  repository.folder.write("new.obj", cut_shirt());
  repository.git({"add", "-A"});
  repository.git({"mv", "with space.obj", "z.obj"});
  const Outcome outcome = repository.git({"diff", "--cached", "--no-renames"});
  CHECK(contains(outcome.out, "a_broken.obj: the old file cannot be compared: line 1: "));
  CHECK(contains(outcome.out, "new.obj: new file: 1,420 faces, "));
  CHECK(contains(outcome.out, "old.obj: deleted file: 1,432 faces, 1,476 vertices\n"));
  CHECK(contains(outcome.out, "with space.obj: deleted file"));
}

TEST_CASE("git diff follows a mesh that was renamed and edited") {
  const Repository repository;
  repository.call_for_diff();
  repository.folder.write("old.obj", shirt());
  repository.commit("A shirt");
  repository.git({"mv", "old.obj", "new.obj"});
  PolygonSoup nudged = shirt();
  nudged.positions[5][0] += 1;
  repository.folder.write("new.obj", nudged);
  const Outcome outcome = repository.git({"diff", "-M", "HEAD"});
  CHECK(contains(outcome.out, "quadmatch diff old.obj new.obj\ndifferent\n"));
  CHECK(contains(outcome.out, "  vertices  1,476 the same, 1 of them moved\n"));
}

TEST_CASE("as a textconv, a renumbered mesh has the same lines, and an edited one others") {
  const Repository repository;
  repository.git({"config", "diff.quadmatch.textconv", "'" QUADMATCH_PROGRAM "' diff --textconv"});
  repository.folder.write("shirt.obj", shirt());
  repository.commit("A shirt");
  repository.folder.write("shirt.obj", shapes::renumbered(shirt(), 9).soup);
  const Outcome same = repository.git({"diff"});
  CHECK_FALSE(contains(same.out, "@@"));
  repository.folder.write("shirt.obj", cut_shirt());
  const Outcome cut = repository.git({"diff"});
  CHECK(contains(cut.out, "\n-faces 1432\n"));
  CHECK(contains(cut.out, "\n+faces 1420\n"));
  CHECK(contains(cut.out, "\n-connectivity "));
}

TEST_CASE("called for git with something else, diff says whose call it is") {
  const Folder folder;
  const Outcome wrong = folder.run({"diff", "--git", "a.obj", "b.obj"});
  CHECK(wrong.status == 2);
  CHECK(contains(wrong.err, "--git is for git to call"));
  const Outcome unmerged = folder.run({"diff", "--git", "a.obj"});
  CHECK(unmerged.status == 0);
  CHECK(unmerged.out == "quadmatch diff a.obj\nnot merged yet\n");
}
