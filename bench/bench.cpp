// What reading and matching cost, from small meshes to millions of quads, beside peers in the same run: tinyobjloader
// for reading, bliss for telling that two meshes are the same. usage: quadmatch_bench MESH.obj STEPS SCRATCH_FOLDER
// [--benchmark_...]
//
// MESH is refined by Catmull-Clark 0 ... STEPS times. At every step the mesh is matched with a copy in the same order,
// and with one whose vertices, faces and first corners are in random order. The finest two are also written to
// SCRATCH_FOLDER and read by both readers.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tiny_obj_loader.h>
#include <bliss/graph.hh>

#include <cstdio>
#include <cstdlib>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <quadmatch/quadmatch.hpp>
#include <quadmatch/shapes/catmull_clark.hpp>
#include <quadmatch/shapes/renumber.hpp>

namespace {

using namespace quadmatch;

struct Subject {
  Mesh source;
  Mesh copy;  ///< in file order: another mesh in memory, as after reading two files
  Mesh renumbered;
  std::string path;  ///< where it was written, if it was
};

[[noreturn]] void give_up(const std::string& why) {
  fmt::print(stderr, "quadmatch_bench: {}\n", why);
  std::exit(2);
}

template <class T>
T take(Expected<T> value) {
  if (!value) give_up(value.error().describe());
  return *std::move(value);
}

PolygonSoup soup_of(const Mesh& mesh) {
  PolygonSoup soup;
  soup.vertex_count = mesh.vertex_count();
  soup.positions.assign(mesh.positions().begin(), mesh.positions().end());
  soup.corners.assign(mesh.corners().begin(), mesh.corners().end());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) soup.face_starts.push_back(mesh.first(FaceId(f)).value);
  soup.face_starts.push_back(mesh.halfedge_count());
  return soup;
}

void report(benchmark::State& state, const Mesh& mesh, std::size_t matched) {
  state.counters["quads"] = mesh.face_count();
  state.counters["matched"] = static_cast<double>(matched);
}

/// Codes, skeletons and anchors of both meshes.
void find_anchors_of(benchmark::State& state, const Mesh& source, const Mesh& target) {
  for (auto _ : state) {
    const PerFan<VertexCode> source_codes = vertex_codes(source);
    const PerFan<VertexCode> target_codes = vertex_codes(target);
    benchmark::DoNotOptimize(find_anchors(source, trace_skeleton(source, source_codes).skeleton, source_codes, target,
                                          trace_skeleton(target, target_codes).skeleton, target_codes));
  }
  report(state, source, 0);
}

/// Everything from two meshes to the match: anchors and growth.
void match_meshes(benchmark::State& state, const Mesh& source, const Mesh& target, Algorithm algorithm) {
  std::size_t matched = 0;
  for (auto _ : state) matched = match(source, target, {.algorithm = algorithm}).match.matched_faces();
  report(state, source, matched);
}

/// Whether one is the other as a whole, and the map.
void lay_isomorphically(benchmark::State& state, const Mesh& source, const Mesh& target) {
  bool same = true;
  for (auto _ : state) same = same && find_isomorphism(source, target).isomorphism.has_value();
  if (!same) give_up("a renumbered mesh is found to be another");
  report(state, source, source.face_count());
}

void count_symmetries(benchmark::State& state, const Mesh& mesh) {
  for (auto _ : state) benchmark::DoNotOptimize(count_automorphisms(mesh));
  report(state, mesh, 0);
}

void hash_connectivity(benchmark::State& state, const Mesh& mesh) {
  for (auto _ : state) benchmark::DoNotOptimize(connectivity_hash(mesh));
  report(state, mesh, 0);
}

/// Vertices and edges, coloured by vertex code as our engine sees them.
bliss::Graph graph_of(const Mesh& mesh) {
  bliss::Graph graph;
  const PerFan<VertexCode> codes = vertex_codes(mesh);
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) graph.add_vertex(codes[FanId(v)].value);
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
    if (mesh.edge(HalfedgeId(h)).value != h) continue;
    graph.add_edge(mesh.origin(HalfedgeId(h)).value, mesh.tip(HalfedgeId(h)).value);
  }
  return graph;
}

/// Are both graphs the same? By the canonical forms of both, as bliss answers it.
void compare_with_bliss(benchmark::State& state, const Mesh& source, const Mesh& target) {
  bool same = true;
  for (auto _ : state) {
    bliss::Graph left = graph_of(source), right = graph_of(target);
    bliss::Stats stats;
    const std::unique_ptr<bliss::Graph> one(left.permute(left.canonical_form(stats, nullptr, nullptr)));
    const std::unique_ptr<bliss::Graph> other(right.permute(right.canonical_form(stats, nullptr, nullptr)));
    same = same && one->cmp(*other) == 0;
  }
  if (!same) give_up("bliss says that a renumbered mesh is another");
  report(state, source, source.face_count());
}

/// How many automorphisms the graph has.
void count_with_bliss(benchmark::State& state, const Mesh& mesh) {
  for (auto _ : state) {
    bliss::Graph graph = graph_of(mesh);
    bliss::Stats stats;
    graph.find_automorphisms(stats, nullptr, nullptr);
    benchmark::DoNotOptimize(stats.get_group_size_approx());
  }
  report(state, mesh, 0);
}

void build_mesh(benchmark::State& state, const Mesh& mesh) {
  const PolygonSoup soup = soup_of(mesh);
  for (auto _ : state) {
    state.PauseTiming();
    PolygonSoup copy = soup;
    state.ResumeTiming();
    benchmark::DoNotOptimize(Mesh::build(std::move(copy)));
  }
}

/// Everything from arrays to the match: what a caller waits for who has no meshes yet.
void build_and_match(benchmark::State& state, const Mesh& source, const Mesh& target) {
  const PolygonSoup source_soup = soup_of(source), target_soup = soup_of(target);
  std::size_t matched = 0;
  for (auto _ : state) {
    state.PauseTiming();
    PolygonSoup source_copy = source_soup, target_copy = target_soup;
    state.ResumeTiming();
    const Mesh source_built = take(Mesh::build(std::move(source_copy)));
    const Mesh target_built = take(Mesh::build(std::move(target_copy)));
    matched = match(source_built, target_built).match.matched_faces();
  }
  report(state, source, matched);
}

void read_with_quadmatch(benchmark::State& state, const std::string& path) {
  for (auto _ : state) benchmark::DoNotOptimize(take(read_mesh(path)));
}

void read_with_tinyobjloader(benchmark::State& state, const std::string& path) {
  for (auto _ : state) {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    const bool triangulate = false;
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, path.c_str(), nullptr, triangulate)) {
      give_up(error);
    }
    benchmark::DoNotOptimize(attributes.vertices.data());
  }
}

void register_benchmark(const char* what, const Mesh& mesh, std::function<void(benchmark::State&)> run) {
  benchmark::RegisterBenchmark(fmt::format("{}/{}", what, mesh.face_count()).c_str(), std::move(run))
      ->Unit(benchmark::kMillisecond);
}

void register_matching(const Subject& subject) {
  const Mesh &source = subject.source, &copy = subject.copy, &renumbered = subject.renumbered;
  const auto add = [&](const char* what, const Mesh& target, Algorithm algorithm) {
    register_benchmark(what, source, [&source, &target, algorithm](benchmark::State& state) {
      match_meshes(state, source, target, algorithm);
    });
  };
  register_benchmark("build", source, [&](benchmark::State& state) { build_mesh(state, renumbered); });
  register_benchmark("from-arrays", source,
                     [&](benchmark::State& state) { build_and_match(state, source, renumbered); });
  register_benchmark("from-arrays-in-file-order", source,
                     [&](benchmark::State& state) { build_and_match(state, source, copy); });
  register_benchmark("anchors", source, [&](benchmark::State& state) { find_anchors_of(state, source, renumbered); });
  add("regions", renumbered, Algorithm::Regions);
  add("regions-in-file-order", copy, Algorithm::Regions);
  add("lazy-greedy", renumbered, Algorithm::LazyGreedy);
  add("lazy-greedy-in-file-order", copy, Algorithm::LazyGreedy);
  add("greedy", renumbered, Algorithm::Greedy);
  register_benchmark("isomorphism", source,
                     [&](benchmark::State& state) { lay_isomorphically(state, source, renumbered); });
  register_benchmark("automorphisms", source, [&](benchmark::State& state) { count_symmetries(state, source); });
  register_benchmark("hash", source, [&](benchmark::State& state) { hash_connectivity(state, source); });
}

void register_reading(Subject& subject, std::string path) {
  MeshFile file{.mesh = subject.source};
  if (const Expected<void> written = write_mesh(path, file); !written) give_up(written.error().describe());
  subject.path = std::move(path);
  register_benchmark("build-in-file-order", subject.source,
                     [&](benchmark::State& state) { build_mesh(state, subject.copy); });
  register_benchmark("read-quadmatch", subject.source,
                     [&](benchmark::State& state) { read_with_quadmatch(state, subject.path); });
  register_benchmark("read-tinyobjloader", subject.source,
                     [&](benchmark::State& state) { read_with_tinyobjloader(state, subject.path); });
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 4) give_up("usage: quadmatch_bench MESH.obj STEPS SCRATCH_FOLDER [--benchmark_...]");
  const int steps = std::atoi(argv[2]);
  PolygonSoup soup = soup_of(take(read_mesh(argv[1])).mesh);
  std::deque<Subject> subjects;  // registered benchmarks keep references
  for (int step = 0; step <= steps; ++step) {
    if (step > 0) soup = shapes::catmull_clark(soup);
    Mesh renumbered = take(Mesh::build(shapes::renumbered(soup, 1).soup));
    Subject& subject =
        subjects.emplace_back(Subject{take(Mesh::build(soup)), take(Mesh::build(soup)), std::move(renumbered), {}});
    register_matching(subject);
    if (step == 0) {
      register_benchmark("bliss", subject.source, [&subject](benchmark::State& state) {
        compare_with_bliss(state, subject.source, subject.renumbered);
      });
      register_benchmark("bliss-automorphisms", subject.source,
                         [&subject](benchmark::State& state) { count_with_bliss(state, subject.source); });
    }
    if (step >= steps - 1) register_reading(subject, fmt::format("{}/{}.obj", argv[3], step));
  }
  benchmark::RunSpecifiedBenchmarks();
  for (const Subject& subject : subjects) {
    if (!subject.path.empty()) std::remove(subject.path.c_str());
  }
  return 0;
}
