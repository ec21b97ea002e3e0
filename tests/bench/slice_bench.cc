#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "services/slicing/algo/section/layer_heights.h"
#include "services/slicing/algo/section/sweep.h"
#include "services/slicing/algo/topology/topology.h"
#include "tests/bench/benchmarks.h"

namespace slicefarm::bench {
namespace {

using slicing::ConnectedMesh;
using slicing::Sweep;

constexpr int kLayers = 400;
constexpr Coord kLayerNm = 100'000;
constexpr int kRuns = 5;

/// Returns a torus of 2 * 1000 * 500 triangles, 40 mm high.
slicing::TorusShape Torus(bool on_planes) {
  return {.ring_radius = 60,
          .tube_radius = 20,
          .around = 1000,
          .sides = 500,
          .snap_to_layer = on_planes ? ToMm(kLayerNm) : 0};
}

struct Result {
  int64_t triangles = 0;
  int64_t layers = 0;
  int64_t segments = 0;
  int64_t loops = 0;
  int64_t open_loops = 0;
  double topology_s = 0;
  double sweep_s = 0;

  double seconds() const { return topology_s + sweep_s; }
};

double Now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<Coord> Planes() {
  std::vector<Coord> planes;
  for (int k = 0; k < kLayers; ++k) planes.push_back(k * kLayerNm + kLayerNm / 2);
  return planes;
}

Result RunOnce(const IndexedMesh& mesh) {
  const std::vector<Coord> planes = Planes();
  Result result;
  IndexedMesh copy = mesh;
  const double start = Now();
  const absl::StatusOr<ConnectedMesh> connected = slicing::Connect(std::move(copy), {});
  result.topology_s = Now() - start;
  if (!connected.ok()) return result;
  const absl::StatusOr<Sweep> sweep = Sweep::Prepare(*connected, planes);
  if (!sweep.ok()) return result;
  slicing::SweepScratch scratch;
  std::vector<slicing::Section> sections;
  for (size_t layer = 0; layer < planes.size(); ++layer)
    sections.push_back(sweep->Cut(layer, scratch));
  result.sweep_s = Now() - start - result.topology_s;
  result.triangles = connected->triangles;
  result.segments = sweep->segments();
  for (const slicing::Section& section : sections) {
    result.layers += !section.loops.empty();
    result.loops += static_cast<int64_t>(section.loops.size());
    result.open_loops += static_cast<int64_t>(section.chains.size());
  }
  return result;
}

Result Best(const IndexedMesh& mesh) {
  Result best = RunOnce(mesh);
  for (int run = 1; run < kRuns; ++run) {
    const Result result = RunOnce(mesh);
    if (result.seconds() < best.seconds()) best = result;
  }
  return best;
}

void Print(const std::string& prefix, const Result& r) {
  const auto count = [&prefix](const char* key, int64_t value) {
    std::printf("%s%s %lld\n", prefix.c_str(), key, static_cast<long long>(value));
  };
  const auto number = [&prefix](const char* key, double value) {
    std::printf("%s%s %.4f\n", prefix.c_str(), key, value);
  };
  count("triangles", r.triangles);
  count("layers", r.layers);
  count("segments", r.segments);
  count("loops", r.loops);
  count("open_loops", r.open_loops);
  number("topology_seconds", r.topology_s);
  number("sweep_seconds", r.sweep_s);
  number("seconds", r.seconds());
  number("segments_per_sweep_second", static_cast<double>(r.segments) / r.sweep_s);
}

}  // namespace

/// Prints the shortest times of a few runs on one thread, for a torus and for a torus with all
/// vertices exactly on the planes. Fails unless every layer has closed loops only.
int BenchSlice() {
  bool sound = true;
  for (const bool on_planes : {false, true}) {
    const absl::StatusOr<IndexedMesh> mesh =
        slicing::PlaceMesh(slicing::TorusMesh(Torus(on_planes)));
    if (!mesh.ok()) return 1;
    IndexedMesh placed = *mesh;
    // Placing moves the lowest ring to 0, but it must be on the first plane.
    if (on_planes)
      for (Vertex& v : placed.vertices) v.z += kLayerNm / 2;
    const Result result = Best(placed);
    Print(on_planes ? "on_vertices_" : "", result);
    sound = sound && result.open_loops == 0 && result.layers == kLayers - (on_planes ? 1 : 0);
  }
  return sound ? 0 : 1;
}

}  // namespace slicefarm::bench
