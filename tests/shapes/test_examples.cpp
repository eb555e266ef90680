#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include <quadmatch/io/file.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>

#include "examples.hpp"

using namespace quadmatch;

TEST_CASE("make_examples makes the very bytes that are shipped") {
  for (const Example& example : make_examples()) {
    CAPTURE(example.name);
    const auto shipped = read_file(std::string(QUADMATCH_EXAMPLES) + "/" + example.name);
    REQUIRE(shipped);
    CHECK((format_mesh(example.file, Format::Obj) == shipped->view()));
    CHECK(shipped->size() < 250'000);
  }
}

TEST_CASE("Each shipped example is read back as it was made") {
  for (const Example& example : make_examples()) {
    CAPTURE(example.name);
    const auto read = parse_mesh(format_mesh(example.file, Format::Obj), example.name);
    REQUIRE(read);
    CHECK(read->mesh.face_count() == example.file.mesh.face_count());
    CHECK(std::equal(read->mesh.corners().begin(), read->mesh.corners().end(), example.file.mesh.corners().begin()));
    CHECK(std::equal(read->mesh.positions().begin(), read->mesh.positions().end(),
                     example.file.mesh.positions().begin(), example.file.mesh.positions().end()));
    CHECK(read->face_records.size() == example.file.face_records.size());
    CHECK(read->texture_coordinates.has_value() == example.file.texture_coordinates.has_value());
    CHECK(read->notes.empty());
  }
}
