#include <doctest/doctest.h>

#include <sqlite3.h>
#include <sys/stat.h>

#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A folder "lib" of four different meshes, one of them in a folder of its own.
void write_meshes(const Folder& folder) {
  fs::create_directories(folder.path("lib/deep er"));
  folder.write("lib/star.obj", shapes::star(5, 6));
  folder.write("lib/dog toy.obj", shapes::dog_toy(3, 8));
  folder.write("lib/deep er/sphere\n2.obj", shapes::sphere(7));
  folder.write("lib/torus.off.obj", shapes::torus(9, 8));
}

Json index(const Folder& folder, int status = 0) {
  const Outcome outcome = folder.run({"index", "lib", "-o", "l.sqlite", "--json"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == status);
  return Json::parse(outcome.out);
}

Json find(const Folder& folder, const std::string& mesh, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"find", mesh, "l.sqlite", "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = folder.run(arguments);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  return Json::parse(outcome.out);
}

void change(const fs::path& database, const char* sql) {
  sqlite3* raw = nullptr;
  REQUIRE(sqlite3_open(database.c_str(), &raw) == SQLITE_OK);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> closed(raw, sqlite3_close);
  REQUIRE(sqlite3_exec(raw, sql, nullptr, nullptr, nullptr) == SQLITE_OK);
}

}  // namespace

TEST_CASE("find names the mesh itself first, with all of its faces, whatever its numbering") {
  const Folder folder;
  write_meshes(folder);
  const Json counts = index(folder);
  CHECK(counts.at("meshes") == 4);
  CHECK(counts.at("added") == 4);
  for (const char* const name : {"star.obj", "dog toy.obj", "deep er/sphere\n2.obj", "torus.off.obj"}) {
    CAPTURE(name);
    REQUIRE(folder.edit_mesh({std::string("lib/") + name, "copy.obj", "renumber"}).status == 0);
    const Json first = find(folder, "copy.obj").at("found").at(0);
    CHECK(first.at("path") == (fs::canonical(folder.path("lib")) / name).string());
    CHECK(first.at("of_this") == 1.0);
    CHECK(first.at("of_that") == 1.0);
    CHECK(first.at("signature").at("common") == 1.0);
  }
}

TEST_CASE("of a hundred meshes find names that among the first three which was edited") {
  const Folder folder;
  fs::create_directories(folder.path("lib"));
  for (int k = 0; k < 100; ++k) {
    const std::string shape = k % 2 == 0 ? fmt::format("star:{},{}", 3 + k % 9, 9 + k / 10)
                                         : fmt::format("dog_toy:{},{}", 2 + k % 7, 12 + k / 5);
    REQUIRE(folder.make_shape({shape, "plain.obj"}).status == 0);
    const Outcome made = folder.edit_mesh({"plain.obj", fmt::format("lib/{}.obj", k), "extrude:9", "refine:12",
                                           "delete:7", "handle", "renumber", "--seed", std::to_string(k)});
    REQUIRE(made.status == 0);
  }
  CHECK(index(folder).at("meshes") == 100);
  int found = 0;
  const char* const edits[] = {"delete", "extrude", "rip", "refine", "loop"};
  for (int k = 0; k < 100; k += 4) {
    const Outcome made = folder.edit_mesh(
        {fmt::format("lib/{}.obj", k), "query.obj", edits[k / 4 % 5], "renumber", "--seed", std::to_string(1000 + k)});
    REQUIRE(made.status == 0);
    const Json answer = find(folder, "query.obj", {"--top", "3"});
    for (const Json& each : answer.at("found")) {
      found += fs::path(each.at("path").get<std::string>()).stem() == std::to_string(k) ? 1 : 0;
    }
  }
  CHECK(found >= 24);
}

TEST_CASE("index reads what is new or changed, forgets what is gone, and leaves the rest alone") {
  const Folder folder;
  write_meshes(folder);
  index(folder);
  CHECK(index(folder).at("unchanged") == 4);
  folder.write("lib/star.obj", shapes::star(6, 7));
  folder.write("lib/new.obj", shapes::grating(2, 3));
  fs::remove(folder.path("lib/torus.off.obj"));
  const Json counts = index(folder);
  CHECK(counts.at("added") == 1);
  CHECK(counts.at("changed") == 1);
  CHECK(counts.at("unchanged") == 2);
  CHECK(counts.at("gone") == 1);
  CHECK(counts.at("meshes") == 4);
  folder.write("query.obj", shapes::star(6, 7));
  CHECK(find(folder, "query.obj").at("found").at(0).at("of_this") == 1.0);
}

TEST_CASE("a library filled in steps answers as one filled at once, for any number of threads") {
  const Folder folder;
  write_meshes(folder);
  index(folder);
  folder.write("lib/a.obj", shapes::grating(2, 3));
  index(folder);
  REQUIRE(folder.run({"index", "lib", "-o", "other.sqlite", "--threads", "1", "--quiet"}).status == 0);
  for (const char* const name : {"lib/a.obj", "lib/star.obj"}) {
    const Json here = Json::parse(folder.run({"find", name, "l.sqlite", "--json"}).out);
    const Json there = Json::parse(folder.run({"find", name, "other.sqlite", "--json"}).out);
    CHECK(here.at("found") == there.at("found"));
  }
}

TEST_CASE("index counts files that are no meshes and keeps why a mesh cannot be read") {
  const Folder folder;
  write_meshes(folder);
  for (int k = 0; k < 2000; ++k) folder.write(fmt::format("lib/note {}.txt", k), "no mesh");
  folder.write("lib/broken.obj", "v 0 0 0\nf 1 2 9\n");
  folder.write("lib/empty.ply", "");
  REQUIRE(::mkfifo(folder.path("lib/pipe.obj").c_str(), 0600) == 0);
  fs::create_directory_symlink("..", folder.path("lib/loop"));
  const Json counts = index(folder, 1);
  CHECK(counts.at("meshes") == 4);
  CHECK(counts.at("broken") == 2);
  CHECK(counts.at("other_files") == 2000);
  const Outcome again = folder.run({"index", "lib", "-o", "l.sqlite"});
  CHECK(again.status == 1);
  CHECK(contains(again.out, "0 added, 0 changed, 6 unchanged, 0 gone"));
  CHECK(contains(again.out, "2 meshes cannot be read"));
}

TEST_CASE("a mesh of the library that is gone is named and ranked by its signature") {
  const Folder folder;
  write_meshes(folder);
  index(folder);
  fs::copy_file(folder.path("lib/star.obj"), folder.path("query.obj"));
  fs::remove(folder.path("lib/star.obj"));
  const Json answer = find(folder, "query.obj");
  bool named = false;
  for (const Json& each : answer.at("found")) {
    if (each.at("note") != "the file is gone") continue;
    named = true;
    CHECK(each.at("signature").at("common") == 1.0);
    CHECK(each.at("matched_faces").is_null());
  }
  CHECK(named);
}

TEST_CASE("find says that there is nothing, and with what status") {
  const Folder folder;
  fs::create_directory(folder.path("lib"));
  index(folder);
  folder.write("query.obj", shapes::star(5, 4));
  const Outcome outcome = folder.run({"find", "query.obj", "l.sqlite"});
  CHECK(outcome.status == 1);
  CHECK(outcome.out == "none of 0 meshes in l.sqlite has anything in common with query.obj\n");
}

TEST_CASE("a library is not emptied because its disk is away, and belongs to one folder") {
  const Folder folder;
  write_meshes(folder);
  index(folder);
  fs::remove_all(folder.path("lib"));
  fs::create_directory(folder.path("lib"));
  const Outcome away = folder.run({"index", "lib", "-o", "l.sqlite"});
  CHECK(away.status == 2);
  CHECK(contains(away.err, "there is no mesh in this folder now, but 4 meshes in the library"));
  fs::create_directory(folder.path("else"));
  const Outcome other = folder.run({"index", "else", "-o", "l.sqlite"});
  CHECK(other.status == 2);
  CHECK(contains(other.err, "this is the library of "));
}

TEST_CASE("a database that is no library, of another version, locked or damaged is refused with what to do") {
  const Folder folder;
  write_meshes(folder);
  const auto refused = [&folder](const char* what) {
    const Outcome filled = folder.run({"index", "lib", "-o", "l.sqlite"});
    CHECK(filled.status == 2);
    CHECK(contains(filled.err, what));
    CHECK(line_count(filled.err) == 1);
    const Outcome asked = folder.run({"find", "lib/star.obj", "l.sqlite"});
    CHECK(asked.status == 2);
    CHECK(contains(asked.err, what));
  };
  CHECK(contains(folder.run({"find", "lib/star.obj", "l.sqlite"}).err, "there is no such library; make it with"));
  change(folder.path("l.sqlite"), "CREATE TABLE t (a)");
  refused("this database is not one of index");
  fs::remove(folder.path("l.sqlite"));
  index(folder);
  change(folder.path("l.sqlite"), "PRAGMA user_version = 99");
  refused("this library is of version 99");
  folder.write("l.sqlite",
               "no database, but a text that is longer than the heading of one is, so that it is looked at");
  refused("this is no database, or a damaged one");
}

TEST_CASE("another process that writes a library is waited for, then named") {
  const Folder folder;
  write_meshes(folder);
  index(folder);
  sqlite3* raw = nullptr;
  REQUIRE(sqlite3_open(folder.path("l.sqlite").c_str(), &raw) == SQLITE_OK);
  const std::unique_ptr<sqlite3, int (*)(sqlite3*)> closed(raw, sqlite3_close);
  REQUIRE(sqlite3_exec(raw, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr) == SQLITE_OK);
  const Outcome filled = folder.run({"index", "lib", "-o", "l.sqlite"});
  CHECK(filled.status == 2);
  CHECK(contains(filled.err, "another program holds this database"));
  CHECK(folder.run({"find", "lib/star.obj", "l.sqlite"}).status == 0);  // reading goes on
}
