#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "common/model/limits.h"
#include "common/model/milling/cutter_text.h"
#include "services/milling/algo/waterline/waterline.h"
#include "services/slicing/algo/mesh_io/mesh_reader.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/thread_seconds.h"

namespace slicefarm::bench {
namespace {

constexpr int kWaterlineRounds = 3;
constexpr int kManyLevels = 50;

/// What OpenCAMlib's Waterline::run gave on one level with one thread.
struct PeerWaterline {
  const char* cutter;
  int loops;
  int points;
  double seconds;
};

/// A model, the share of its height at which the level lies, the sampling in mm.
struct WaterlineCase {
  const char* file;
  double share;
  double sampling_mm;
  std::array<PeerWaterline, 4> peer;
};

constexpr std::array kWaterlineCases = {
    WaterlineCase{"sphere",
                  .63,
                  .5,
                  {{{"cyl:6", 1, 820, 0.18},
                    {"ball:6", 1, 804, 0.16},
                    {"bull:6:1.5", 1, 812, 0.38},
                    {"cone:6:45", 1, 804, 0.18}}}},
    WaterlineCase{"30sphere",
                  .37,
                  .2,
                  {{{"cyl:4", 1, 1280, 1.35},
                    {"ball:4", 1, 1280, 1.51},
                    {"bull:4:1", 1, 1280, 4.71},
                    {"cone:4:45", 1, 1280, 1.69}}}},
    WaterlineCase{"demo",
                  .37,
                  .05,
                  {{{"cyl:1", 2, 560, 0.20},
                    {"ball:1", 2, 496, 0.19},
                    {"bull:1:0.25", 2, 528, 0.81},
                    {"cone:1:45", 2, 472, 0.23}}}},
    WaterlineCase{"beet_mm",
                  .37,
                  .1,
                  {{{"cyl:2", 2, 1340, 0.59},
                    {"ball:2", 2, 1334, 0.69},
                    {"bull:2:0.5", 2, 1328, 3.21},
                    {"cone:2:45", 2, 1330, 0.84}}}},
    WaterlineCase{"mount_rush_open",
                  .37,
                  .2,
                  {{{"cyl:2", 2, 1764, 1.13},
                    {"ball:2", 4, 1838, 1.30},
                    {"bull:2:0.5", 2, 1788, 3.93},
                    {"cone:2:45", 2, 1918, 1.40}}}},
    WaterlineCase{"wheel_in_box",
                  .37,
                  .5,
                  {{{"cyl:6", 20, 4980, 0.59},
                    {"ball:6", 20, 4926, 0.69},
                    {"bull:6:1.5", 20, 4970, 2.17},
                    {"cone:6:45", 20, 4890, 0.74}}}},
    WaterlineCase{"sphere_on_plate",
                  .63,
                  .2,
                  {{{"cyl:4", 1, 692, 1.06},
                    {"ball:4", 1, 676, 1.28},
                    {"bull:4:1", 1, 684, 4.37},
                    {"cone:4:45", 1, 668, 1.25}}}},
};

std::optional<milling::TriangleMesh> MeshIn(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const auto raw = slicing::ReadMesh(bytes, MeshFormat::kUnknown, limits::kMaxMeshCoordinateMm, {});
  if (!raw.ok()) return std::nullopt;
  milling::TriangleMesh mesh;
  for (const slicing::Position& p : raw->positions) mesh.points_mm.push_back({p.x, p.y, p.z});
  mesh.triangles = raw->triangles;
  return mesh;
}

struct TimedWaterline {
  size_t loops = 0;
  size_t points = 0;
  double seconds = 0;  ///< the best of some rounds
};

TimedWaterline Timed(const milling::TriangleMesh& mesh, const Cutter& cutter,
                     const std::vector<double>& levels_mm, double sampling_mm) {
  TimedWaterline timed{.seconds = 1e9};
  for (int round = 0; round < kWaterlineRounds; ++round) {
    const double start = ThreadSeconds();
    const auto levels = milling::Waterlines(mesh, cutter, levels_mm, {.sampling_mm = sampling_mm});
    timed.seconds = std::min(timed.seconds, ThreadSeconds() - start);
    if (!levels.ok()) return {};
    timed.loops = timed.points = 0;
    for (const auto& level : *levels) {
      timed.loops += level.size();
      for (const milling::WaterlineLoop& loop : level) timed.points += loop.points_mm.size();
    }
  }
  return timed;
}

void BenchModel(const WaterlineCase& model, const milling::TriangleMesh& mesh) {
  double low = mesh.points_mm[0].z(), high = low;
  for (const Eigen::Vector3d& p : mesh.points_mm)
    low = std::min(low, p.z()), high = std::max(high, p.z());
  std::vector<double> many;
  for (int i = 0; i < kManyLevels; ++i)
    many.push_back(low + (i + 0.5) / kManyLevels * (high - low));
  for (const PeerWaterline& peer : model.peer) {
    const auto cutter = ParseCutter(peer.cutter);
    const TimedWaterline one =
        Timed(mesh, *cutter, {low + model.share * (high - low)}, model.sampling_mm);
    const TimedWaterline all = Timed(mesh, *cutter, many, model.sampling_mm);
    std::printf("%s | %zu | %s | %zu / %zu | %.1f | %.2f | %d / %d | %.0f | %.0f | %.0f\n",
                model.file, mesh.triangles.size(), peer.cutter, one.loops, one.points,
                1e3 * one.seconds, 1e3 * all.seconds / kManyLevels, peer.loops, peer.points,
                1e3 * peer.seconds, peer.seconds / one.seconds,
                peer.seconds * kManyLevels / all.seconds);
  }
}

}  // namespace

int BenchWaterline(const std::string& models) {
  std::printf(
      "model | triangles | cutter | loops / points | ms | ms a level of 50 | OpenCAMlib's loops / "
      "points | ms | times faster | of 50 levels\n");
  for (const WaterlineCase& model : kWaterlineCases) {
    const auto mesh = MeshIn(models + "/" + model.file + ".stl");
    if (mesh)
      BenchModel(model, *mesh);
    else
      std::fprintf(stderr, "%s.stl is not in %s\n", model.file, models.c_str());
  }
  return 0;
}

}  // namespace slicefarm::bench
