// --image and --animation: pictures a verb writes beside its figures.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

void write_pair(const Folder& folder) {
  const PolygonSoup star = shapes::star(5, 3);
  folder.write("a.obj", shapes::disjoint_union({star, shapes::cube()}));
  folder.write("b.obj", shapes::renumbered(star, 1).soup);
}

/// Width and height of a PNG, as its header has them.
std::pair<unsigned, unsigned> size_of_png(const std::string& bytes) {
  REQUIRE(bytes.size() > 33);
  REQUIRE(bytes.starts_with("\x89PNG\r\n\x1a\n"));
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8U | static_cast<unsigned char>(bytes[at + k]);
    return value;
  };
  return {number(16), number(20)};
}

/// "width,height,frames" as ffprobe counts them.
std::string probed(const Folder& folder, const std::string& name) {
  return folder
      .shell("ffprobe -v error -count_frames -show_entries stream=width,height,nb_read_frames -of csv=p=0 " + name)
      .out;
}

}  // namespace

TEST_CASE("match --image and --animation write pictures, and without -o no match file") {
  const Folder folder;
  write_pair(folder);
  const Outcome outcome =
      folder.run({"match", "a.obj", "b.obj", "--image", "ab.png", "--animation", "ab.webp", "--image-size", "320x160"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "written  ab.png\n         ab.webp\n"));
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "ab.png", "ab.webp", "b.obj"});
  CHECK(size_of_png(folder.read("ab.png")) == std::pair{320U, 160U});
  CHECK(folder.read("ab.webp").substr(0, 4) == "RIFF");
  CHECK(folder.read("ab.webp").substr(8, 4) == "WEBP");

  const Outcome figures = folder.run({"match", "a.obj", "b.obj", "--image", "ab.png", "--json"});
  CHECK(Json::parse(figures.out).at("pictures") == Json::array({"ab.png"}));
  CHECK(size_of_png(folder.read("ab.png")) == std::pair{1280U, 640U});
  CHECK(Json::parse(folder.run({"match", "a.obj", "b.obj", "--json"}).out).at("pictures") == Json::array());
}

TEST_CASE("pictures change nothing of the match file, and are the same on every run and for any number of threads") {
  const Folder folder;
  write_pair(folder);
  folder.run({"match", "a.obj", "b.obj", "-o", "plain.json", "--quiet"});
  const auto draw = [&](const std::string& threads, const std::string& name) {
    const Outcome outcome = folder.run({"match", "a.obj", "b.obj", "-o", "drawn.json", "--image", name + ".png",
                                        "--animation", name + ".webp", "--threads", threads, "--quiet"});
    CHECK(outcome.status == 0);
    CHECK(outcome.out.empty());
    CHECK((folder.read("plain.json") == folder.read("drawn.json")));
  };
  draw("1", "one");
  draw("2", "two");
  draw("0", "any");
  for (const std::string other : {"two", "any"}) {
    CHECK((folder.read("one.png") == folder.read(other + ".png")));
    CHECK((folder.read("one.webp") == folder.read(other + ".webp")));
  }
}

TEST_CASE("GIF and MP4 have every wave and the picture, which stands longer, and are the same on every run") {
  const Folder folder;
  if (folder.shell("command -v ffmpeg && command -v ffprobe").status != 0) {
    MESSAGE("ffmpeg is not here, so this is not tested; scripts/install.sh web");
    return;
  }
  write_pair(folder);
  folder.run({"match", "a.obj", "b.obj", "-o", "m.json", "--waves", "--quiet"});
  std::size_t waves = 0;
  const Json match = Json::parse(folder.read("m.json"));
  for (const Json& region : match.at("regions")) waves = std::max(waves, region.at("waves").size());
  REQUIRE(waves > 1);
  const std::size_t step = std::min<std::size_t>(400, 6000 / (waves + 1)) / 10 * 10;
  const std::size_t frames = waves + (2400 + step - 1) / step;
  // MP4 is of even size.
  for (const auto& [ending, size] : {std::pair{"gif", "161,81"}, std::pair{"mp4", "162,82"}}) {
    const std::string name = std::string("film.") + ending;
    const std::vector<std::string> command{"match", "a.obj", "b.obj", "--animation", name, "--image-size", "161x81"};
    const Outcome outcome = folder.run(command);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    const std::string count = std::to_string(ending == std::string("gif") ? waves + 1 : frames);
    CAPTURE(count);
    CHECK(contains(probed(folder, name), size));
    const std::string first = folder.read(name);
    folder.run(command);
    CHECK((folder.read(name) == first));
    if (ending == std::string("mp4")) CHECK(probed(folder, name) == std::string(size) + "," + count + "\n");
  }
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "b.obj", "film.gif", "film.mp4", "m.json"});
}

TEST_CASE("diff draws what it compared, merge the base beside the result, symmetry a mesh beside itself") {
  const Folder folder;
  const PolygonSoup shirt = shapes::shirt(shapes::Sleeves::Short).soup;
  folder.write("a.obj", shirt);
  const Expected<shapes::Edit> edit = shapes::delete_patch(shirt, FaceId(600), 12);
  REQUIRE(edit.has_value());
  folder.write("cut.obj", shapes::renumbered(edit->soup, 4).soup);
  const Outcome diff =
      folder.run({"diff", "a.obj", "cut.obj", "--image", "d.png", "--animation", "d.webp", "--image-size", "64x32"});
  CHECK(diff.status == 1);
  CHECK(contains(diff.out, "  written   d.png\n            d.webp\n"));
  const Outcome merge = folder.run({"merge", "a.obj", "cut.obj", "a.obj", "-o", "m.obj", "--image", "m.png"});
  CHECK(merge.status == 0);
  CHECK(contains(merge.out, "written    m.obj\n           m.png\n"));
  folder.write("ball.obj", shapes::sphere(8));
  const Outcome symmetry = folder.run({"symmetry", "ball.obj", "--image", "s.png", "--image-view", "back"});
  CHECK(symmetry.status == 0);
  CHECK(contains(symmetry.out, "written      s.png\n"));
  CHECK(size_of_png(folder.read("d.png")) == std::pair{64U, 32U});
  CHECK(size_of_png(folder.read("m.png")) == std::pair{1280U, 640U});
  CHECK(size_of_png(folder.read("s.png")) == std::pair{1280U, 640U});
  CHECK(folder.names() ==
        std::vector<std::string>{"a.obj", "ball.obj", "cut.obj", "d.png", "d.webp", "m.obj", "m.png", "s.png"});

  const Outcome misplaced = folder.run({"diff", "a.obj", "cut.obj", "--isomorphic", "--image", "d.png"});
  CHECK(misplaced.status == 2);
  CHECK(contains(misplaced.err, "--image is about comparing part by part"));
}

TEST_CASE("a picture that cannot be made is trouble in one line, before any work is done, and nothing is overwritten") {
  const Folder folder;
  write_pair(folder);
  const std::string before = folder.read("a.obj");
  const std::string size = ": a size is a width and a height in pixels from 16 to 8192, such as 1280x640";
  check_refused(
      folder, {"match", "a.obj", "b.obj"},
      {{{"--image", "a.jpg"}, "a.jpg: pictures are written as PNG; choose a name that ends in .png"},
       {{"--animation", "a.avi"},
        "a.avi: the name does not tell how the animation is to be stored; end it in .webp, .gif or .mp4"},
       {{"--image", "-"}, "--image needs the name of a file; - is for standard output, which has the figures"},
       {{"--image", "a.obj"}, "a.obj: this is an input and would be overwritten; choose another name for --image"},
       {{"--image", "m.png", "-o", "./m.png"},
        "m.png: --image and another option name the same file; choose another name for one of them"},
       {{"--image", "m.png", "--report", "m.png"},
        "m.png: --image and another option name the same file; choose another name for one of them"},
       {{"--image", "m.webp", "--animation", "m.webp"},
        "m.webp: --animation and another option name the same file; choose another name for one of them"},
       {{"--image-size", "64x64"}, "--image-size is about a picture, and none is asked for; add --image FILE"},
       {{"--image-view", "front"}, "--image-view is about a picture, and none is asked for; add --image FILE"},
       {{"--image", "m.png", "--image-size", "0x0"}, "--image-size 0x0" + size},
       {{"--image", "m.png", "--image-size", "640"}, "--image-size 640" + size},
       {{"--image", "m.png", "--image-size", "640x"}, "--image-size 640x" + size},
       {{"--image", "m.png", "--image-size", "-5x20"}, "--image-size -5x20" + size},
       {{"--image", "m.png", "--image-size", "640x480px"}, "--image-size 640x480px" + size},
       {{"--image", "m.png", "--image-size", "99999x99999"}, "--image-size 99999x99999" + size}});
  const Outcome missing = folder.run({"match", "a.obj", "b.obj", "--image", "none/m.png"});
  CHECK(missing.status == 2);
  CHECK(line_count(missing.err) == 1);
  CHECK(contains(missing.err, "none/m.png"));
  CHECK((folder.read("a.obj") == before));
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "b.obj"});
}

TEST_CASE("without ffmpeg a GIF is refused with what to do, and WebP is made all the same") {
  const Folder folder;
  write_pair(folder);
  const Outcome gif = folder.shell("PATH=. \"$QUADMATCH\" match a.obj b.obj --animation ab.gif");
  CHECK(gif.status == 2);
  CHECK(gif.err ==
        "quadmatch: ab.gif: this needs the program ffmpeg, which is not there; install it, or choose a name that ends "
        "in .webp\n");
  CHECK(folder.shell("PATH=. \"$QUADMATCH\" match a.obj b.obj --animation ab.webp --quiet").status == 0);
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "ab.webp", "b.obj"});
}

TEST_CASE("what ffmpeg complains of is passed on, and nothing is written") {
  const Folder folder;
  write_pair(folder);
  folder.shell("printf '#!/bin/sh\\necho no room left >&2\\nexit 3\\n' > ffmpeg && chmod +x ffmpeg");
  const Outcome outcome = folder.shell("PATH=.:$PATH \"$QUADMATCH\" match a.obj b.obj --animation ab.mp4");
  CHECK(outcome.status == 2);
  CHECK(outcome.err == "quadmatch: ab.mp4: ffmpeg did not make the animation: no room left\n");
  CHECK_FALSE(folder.has("ab.mp4"));
}
