// What the page does with meshes, by the steps it takes them in.

#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <quadmatch/io/file.hpp>
#include <quadmatch/io/match_file.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/use/transfer.hpp>
#include <quadmatch/verify/verify.hpp>

#include "page/session.hpp"

using namespace quadmatch;
using page::Session;
using page::Slot;

namespace {

constexpr const char* kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";

std::string example(const std::string& name) {
  const Expected<FileBytes> bytes = read_file(QUADMATCH_EXAMPLES "/" + name);
  REQUIRE(bytes.has_value());
  return std::string(bytes->view());
}

Session session() { return Session(page::Listener{}); }

void read(Session& session, Slot slot, const std::string& bytes, const std::string& name) {
  const Expected<std::vector<std::string>> warnings = session.read(slot, FileBytes(bytes), name);
  REQUIRE_MESSAGE(warnings.has_value(), warnings.error().describe());
}

/// The bears, matched.
Session bears() {
  Session bears = session();
  read(bears, Slot::Source, example("bear.obj"), "bear.obj");
  read(bears, Slot::Target, example("bear_no_ears_posed.obj"), "other.obj");
  REQUIRE(bears.match().has_value());
  return bears;
}

}  // namespace

TEST_CASE("the match file of the page names the files, holds the settings and is sound") {
  Session session = bears();
  const Expected<std::string> bytes = session.match_file();
  REQUIRE(bytes.has_value());
  const Expected<MatchFile> file = parse_match(*bytes, "page");
  REQUIRE(file.has_value());
  CHECK(file->source.path == "bear.obj");
  CHECK(file->target == MatchSide{"other.obj", 2690, 2688});
  CHECK(file->match.matched_faces() == 2644);
  for (const Region& region : file->match.regions) CHECK(region.waves.empty());
  CHECK(bytes->find("\"algorithm\": \"regions\", \"orientation\": \"auto\"") != std::string::npos);
  const Expected<MeshFile> source = parse_mesh(example("bear.obj"), "a.obj");
  const Expected<MeshFile> target = parse_mesh(example("bear_no_ears_posed.obj"), "b.obj");
  CHECK(verify(source->mesh, target->mesh, file->match).sound());
}

TEST_CASE("options are those of the command line by the same words, and others are refused") {
  Session session = bears();
  CHECK(session.choose("algorithm", "greedy").has_value());
  CHECK(session.choose("orientation", "preserving").has_value());
  CHECK(session.choose("positions", "false").has_value());
  CHECK(session.choose("min-region", "10").has_value());
  CHECK(session.choose("min-confidence", "0.5").has_value());
  REQUIRE(session.match().has_value());
  const std::string file = *session.match_file();
  CHECK(file.find("\"algorithm\": \"greedy\", \"orientation\": \"preserving\"") != std::string::npos);
  CHECK(file.find("\"positions\": \"false\"") != std::string::npos);
  const std::vector<std::pair<const char*, const char*>> wrong{
      {"algorithm", "best"}, {"orientation", ""},        {"positions", "no"},     {"min-region", "-1"},
      {"min-region", "1.5"}, {"min-region", "1 "},       {"min-confidence", "2"}, {"min-confidence", "nan"},
      {"time-limit", "-1"},  {"time-limit", "infinity"}, {"prefer", "everybody"}, {"colour", "red"}};
  for (const auto& [name, value] : wrong) {
    const Expected<void> chosen = session.choose(name, value);
    REQUIRE_FALSE(chosen.has_value());
    CHECK(chosen.error().message == std::string(name) + " cannot be \"" + value + "\"");
  }
}

TEST_CASE("a time limit is for the exact search alone, and ends it") {
  Session session = bears();
  REQUIRE(session.choose("time-limit", "0.001").has_value());
  CHECK_FALSE(session.match().has_value());
  REQUIRE(session.choose("algorithm", "exact").has_value());
  REQUIRE(session.match().has_value());
  CHECK(session.match_file()->find("\"time_limit\": \"0.001\"") != std::string::npos);
}

TEST_CASE("a broken file is refused by name and line, and a mesh that was there is gone") {
  Session session = bears();
  const Expected<std::vector<std::string>> read =
      session.read(Slot::Target, FileBytes("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n"), "broken.obj");
  REQUIRE_FALSE(read.has_value());
  CHECK(read.error().describe().starts_with("broken.obj:4: "));
  CHECK_FALSE(session.match().has_value());
  CHECK_FALSE(session.match_file().has_value());
}

TEST_CASE("what the reader guessed and what is dirty is told as by the command line") {
  Session session = ::session();
  const Expected<std::vector<std::string>> warnings =
      session.read(Slot::Source, FileBytes(std::string(kQuad) + "v 9 9 9\n"), "dirty.obj");
  REQUIRE(warnings.has_value());
  CHECK(*warnings == std::vector<std::string>{"dirty.obj: 1 unused vertex; matching goes on"});
}

TEST_CASE("a new mesh of the pair makes the match void, another edit does not") {
  Session session = bears();
  read(session, Slot::Other, kQuad, "third.obj");
  CHECK(session.match_file().has_value());
  read(session, Slot::Source, kQuad, "quad.obj");
  CHECK_FALSE(session.match_file().has_value());
  CHECK_FALSE(session.transferred("t.obj").has_value());
}

TEST_CASE("the target with the source's data has its format by the name, and says what was carried") {
  const Session session = bears();
  const Expected<page::Product> ply = session.transferred("t.ply");
  REQUIRE(ply.has_value());
  CHECK(parse_mesh(ply->bytes, "t.ply", Format::Ply)->mesh.face_count() == 2688);
  CHECK(ply->summary.starts_with("source "));
  CHECK(ply->summary.find("t.ply") != std::string::npos);
  const Expected<page::Product> odd = session.transferred("t.xyz");
  REQUIRE_FALSE(odd.has_value());
  CHECK(odd.error().describe() == "t.xyz: the name does not tell the format; end it in .obj, .ply, .off or .usda");
}

TEST_CASE("where nothing is the same nothing is carried, and that is said") {
  Session session = ::session();
  read(session, Slot::Source, std::string("vt 0 0\n") + kTriangle, "triangle.obj");
  read(session, Slot::Target, kQuad, "quad.obj");
  REQUIRE(session.match().has_value());
  const Expected<page::Product> product = session.transferred("t.obj");
  REQUIRE_FALSE(product.has_value());
  CHECK(product.error().code == ErrorCode::BadArgument);
}

TEST_CASE("a merge needs three meshes, and takes the changes of both") {
  Session session = ::session();
  read(session, Slot::Source, kQuad, "base.obj");
  read(session, Slot::Target, kQuad, "mine.obj");
  CHECK(session.merged("m.obj").error().message == "three meshes are needed: a base and two edits of it");
  read(session, Slot::Other, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 7\nf 1 2 3 4\n", "yours.obj");
  const Expected<page::Product> merged = session.merged("m.obj");
  REQUIRE(merged.has_value());
  CHECK(merged->bytes.find("v 0 1 7") != std::string::npos);
  CHECK(merged->summary.starts_with("base "));
}

TEST_CASE("the page is told what is being done and how far it is") {
  std::vector<std::string> stages;
  std::size_t most = 0;
  Session session(page::Listener{.stage = [&](std::string_view stage) { stages.emplace_back(stage); },
                                 .progress = [&](std::size_t done, std::size_t all) { most = std::max(done, all); }});
  read(session, Slot::Source, example("bear.obj"), "bear.obj");
  read(session, Slot::Target, example("bear_no_ears_posed.obj"), "posed.obj");
  REQUIRE(session.match().has_value());
  CHECK(stages == std::vector<std::string>{"matching", "verifying", "making the report"});
  CHECK(most > 0);
}
