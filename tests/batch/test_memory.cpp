#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

#include <quadmatch/io/file.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "batch/memory_gate.hpp"
#include "batch/memory_need.hpp"

using namespace quadmatch;
using namespace quadmatch::cli;

namespace {

namespace fs = std::filesystem;

/// A file in the folder for temporary ones, removed at the end.
struct Temporary {
  explicit Temporary(const std::string& ending)
      : path((fs::temp_directory_path() / ("quadmatch-batch-" + std::to_string(::getpid()) + ending)).string()) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() { fs::remove(path); }
  std::string path;
};

}  // namespace

TEST_CASE("the corners of a file are counted without reading the mesh, for every format") {
  const Expected<Mesh> mesh = Mesh::build(shapes::sphere(20));
  REQUIRE(mesh.has_value());
  const std::uint64_t corners = mesh->halfedge_count();
  for (const auto& [ending, format] : {std::pair(".obj", Format::Obj), std::pair(".ply", Format::Ply),
                                       std::pair(".off", Format::Off), std::pair(".usda", Format::Usda)}) {
    CAPTURE(ending);
    const Temporary file(ending);
    REQUIRE(write_mesh(file.path, MeshFile{*mesh, format}).has_value());
    const Expected<MeshSize> size = measure_mesh_file(file.path);
    REQUIRE(size.has_value());
    CHECK(size->bytes == fs::file_size(file.path));
    CHECK(size->corners >= corners * 97 / 100);
    CHECK(size->corners <= corners * 3 / 2);
  }
}

TEST_CASE("a header that promises too much counts for no more than the file can hold") {
  const Temporary file(".ply");
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 4\nelement face 4000000000\n";
  REQUIRE(replace_file(file.path, header).has_value());
  CHECK(measure_mesh_file(file.path)->corners == header.size());
}

TEST_CASE("a missing file and a folder are no meshes") {
  CHECK(measure_mesh_file("/nonexistent/a.obj").error().message ==
        "there is no such file; check the name and the folder");
  CHECK(measure_mesh_file("/tmp").error().code == ErrorCode::CannotRead);
}

TEST_CASE("those inside the gate never hold more than the limit, and all get in") {
  MemoryGate gate(100);
  std::atomic<int> held = 0, most = 0, passed = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&, t] {
      for (int k = 0; k < 200; ++k) {
        const int bytes = 1 + (t * 37 + k * 11) % 100;
        const MemoryGate::Share share = gate.enter(static_cast<std::uint64_t>(bytes));
        const int now = held += bytes;
        for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) continue;
        held -= bytes;
        ++passed;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(passed == 1600);
  CHECK(most <= 100);
}
