// What reading and matching cost, from small meshes to millions of quads, beside peers in the same run: tinyobjloader
// for reading, bliss for telling that two meshes are the same. usage: quadmatch_bench MESH.obj STEPS SCRATCH.obj
// [--benchmark_...]
//
// MESH is refined by Catmull-Clark 0 ... STEPS times. At every step the mesh is matched with a copy whose vertices,
// faces and first corners are in random order. The finest is also written to SCRATCH and read by both readers.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tiny_obj_loader.h>
#include <bliss/graph.hh>

#include <cstdio>
#include <cstdlib>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include <quadmatch/quadmatch.hpp>
#include <quadmatch/shapes/catmull_clark.hpp>
#include <quadmatch/shapes/renumber.hpp>

namespace {

using namespace quadmatch;

struct Pair {
  Mesh source;
  Mesh target;
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

void report(benchmark::State& state, const Pair& pair, std::size_t matched) {
  state.counters["quads"] = pair.source.face_count();
  state.counters["matched"] = static_cast<double>(matched);
}

/// Codes, skeletons and anchors of both meshes.
void find_anchors_of(benchmark::State& state, const Pair& pair) {
  for (auto _ : state) {
    const PerFan<VertexCode> source_codes = vertex_codes(pair.source);
    const PerFan<VertexCode> target_codes = vertex_codes(pair.target);
    benchmark::DoNotOptimize(find_anchors(pair.source, trace_skeleton(pair.source, source_codes).skeleton, source_codes,
                                          pair.target, trace_skeleton(pair.target, target_codes).skeleton,
                                          target_codes));
  }
  report(state, pair, 0);
}

/// Everything from two meshes to the match: anchors and growth.
void match_pair(benchmark::State& state, const Pair& pair, Algorithm algorithm) {
  std::size_t matched = 0;
  for (auto _ : state) matched = match(pair.source, pair.target, {.algorithm = algorithm}).match.matched_faces();
  report(state, pair, matched);
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
void compare_with_bliss(benchmark::State& state, const Pair& pair) {
  bool same = true;
  for (auto _ : state) {
    bliss::Graph left = graph_of(pair.source), right = graph_of(pair.target);
    bliss::Stats stats;
    const std::unique_ptr<bliss::Graph> one(left.permute(left.canonical_form(stats, nullptr, nullptr)));
    const std::unique_ptr<bliss::Graph> other(right.permute(right.canonical_form(stats, nullptr, nullptr)));
    same = same && one->cmp(*other) == 0;
  }
  if (!same) give_up("bliss says that a renumbered mesh is another");
  report(state, pair, pair.source.face_count());
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

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 4) give_up("usage: quadmatch_bench MESH.obj STEPS SCRATCH.obj [--benchmark_...]");
  const std::string scratch = argv[3];
  PolygonSoup soup = soup_of(take(read_mesh(argv[1])).mesh);
  std::deque<Pair> pairs;  // registered benchmarks keep references
  for (int step = 0; step <= std::atoi(argv[2]); ++step) {
    if (step > 0) soup = shapes::catmull_clark(soup);
    Mesh target = take(Mesh::build(shapes::renumbered(soup, 1).soup));
    const Pair& pair = pairs.emplace_back(Pair{take(Mesh::build(soup)), std::move(target)});
    const auto name = [&](const char* what) { return fmt::format("{}/{}", what, pair.source.face_count()); };
    const auto add = [&](const char* what, auto run) {
      benchmark::RegisterBenchmark(name(what).c_str(), run)->Unit(benchmark::kMillisecond);
    };
    add("build", [&pair](benchmark::State& state) { build_mesh(state, pair.target); });
    add("anchors", [&pair](benchmark::State& state) { find_anchors_of(state, pair); });
    add("regions", [&pair](benchmark::State& state) { match_pair(state, pair, Algorithm::Regions); });
    if (step == 0) add("bliss", [&pair](benchmark::State& state) { compare_with_bliss(state, pair); });
    add("lazy-greedy", [&pair](benchmark::State& state) { match_pair(state, pair, Algorithm::LazyGreedy); });
    add("greedy", [&pair](benchmark::State& state) { match_pair(state, pair, Algorithm::Greedy); });
  }
  MeshFile file{.mesh = take(Mesh::build(std::move(soup)))};
  if (const Expected<void> written = write_mesh(scratch, file); !written) give_up(written.error().describe());
  const auto read = [&](const char* what, void (*run)(benchmark::State&, const std::string&)) {
    benchmark::RegisterBenchmark(fmt::format("{}/{}", what, file.mesh.face_count()).c_str(),
                                 [&, run](benchmark::State& state) { run(state, scratch); })
        ->Unit(benchmark::kMillisecond);
  };
  benchmark::RegisterBenchmark(fmt::format("build-in-file-order/{}", file.mesh.face_count()).c_str(),
                               [&](benchmark::State& state) { build_mesh(state, file.mesh); })
      ->Unit(benchmark::kMillisecond);
  read("read-quadmatch", read_with_quadmatch);
  read("read-tinyobjloader", read_with_tinyobjloader);
  benchmark::RunSpecifiedBenchmarks();
  std::remove(scratch.c_str());
  return 0;
}
