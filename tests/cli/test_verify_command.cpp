#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/io/match_file.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

/// A strip of three quads and its match with itself, the last pair turned by half where it is to be broken.
void write_match_of_strip(const Folder& folder, bool broken) {
  folder.write("strip.obj", shapes::grid(3, 1));
  MatchFile file;
  file.source = file.target = {"strip.obj", 8, 3};
  file.match.regions.push_back(
      {.faces = {{FaceId(0), FaceId(0), 0}, {FaceId(1), FaceId(1), 0}, {FaceId(2), FaceId(2), broken ? 2U : 0U}}});
  for (std::uint32_t v = 0; v < 8; ++v) file.match.vertices.push_back({VertexId(v), VertexId(v)});
  folder.write("m.json", format_match(file));
}

const std::vector<std::string> kVerify{"verify", "strip.obj", "strip.obj", "m.json"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace

TEST_CASE("verify calls a sound match sound") {
  const Folder folder;
  write_match_of_strip(folder, false);
  const Outcome outcome = folder.run(kVerify);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out ==
        "sound\n"
        "  matched   3 faces: 100.0 % of the source, 100.0 % of the target\n"
        "  vertices  8 with a partner\n"
        "  regions   1, the largest of 3 faces\n");
}

TEST_CASE("verify names the first faults, counts all, and exits with 1") {
  const Folder folder;
  write_match_of_strip(folder, true);
  const Outcome outcome = folder.run(with(kVerify, {"--faults", "1"}));
  CHECK(outcome.status == 1);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.rfind("not sound: 8 faults\n"
                          "  region 0, pair 2 -> 2: source vertex 2 has two images, 2 and 7\n"
                          "  and 7 more\n",
                          0) == 0);
}

TEST_CASE("verify --json says what tools/verify_match.py says, and the faults") {
  const Folder folder;
  write_match_of_strip(folder, false);
  const Outcome sound = folder.run(with(kVerify, {"--json"}));
  CHECK(sound.status == 0);
  CHECK(Json::parse(sound.out) == Json{{"valid", true},
                                       {"faults", 0},
                                       {"regions", 1},
                                       {"largest_region", 3},
                                       {"matched_faces", 3},
                                       {"source_faces", 3},
                                       {"target_faces", 3},
                                       {"source_coverage", 1.0},
                                       {"target_coverage", 1.0},
                                       {"matched_vertices", 8},
                                       {"messages", Json::array()}});
  write_match_of_strip(folder, true);
  const Outcome broken = folder.run(with(kVerify, {"--json"}));
  CHECK(broken.status == 1);
  CHECK(Json::parse(broken.out).at("valid") == false);
  CHECK(Json::parse(broken.out).at("messages").size() == 8);
}

TEST_CASE("verify --quiet only sets the exit status") {
  const Folder folder;
  for (const bool broken : {false, true}) {
    write_match_of_strip(folder, broken);
    const Outcome outcome = folder.run(with(kVerify, {"--quiet"}));
    CHECK(outcome.status == (broken ? 1 : 0));
    CHECK(outcome.out.empty());
    CHECK(outcome.err.empty());
  }
}

TEST_CASE("verify reads the match file from standard input") {
  const Folder folder;
  write_match_of_strip(folder, false);
  CHECK(folder.run({"verify", "strip.obj", "strip.obj", "-"}, folder.read("m.json")).status == 0);
}
