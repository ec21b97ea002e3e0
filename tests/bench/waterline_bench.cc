#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/vector.h"
#include "common/model/limits.h"
#include "common/model/options/cutter_text.h"
#include "services/milling/algo/waterline/waterline.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/thread_seconds.h"

namespace slicefarm::bench {
namespace {

constexpr int kWaterlineRounds = 3;
constexpr int kManyLevels = 50;
constexpr int kLevelsOfMillion = 100;

/// Result of OpenCAMlib's Waterline::run on one level with one thread.
struct PeerWaterline {
  const char* cutter;
  int loops;
  int points;
  double seconds;
};

/// Model, level as a share of its height, and sampling in mm.
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
    WaterlineCase{"spider",
                  .37,
                  .05,
                  {{{"cyl:0.6", 1, 1828, 1.65},
                    {"ball:0.6", 1, 1828, 2.00},
                    {"bull:0.6:0.15", 1, 1828, 5.16},
                    {"cone:0.6:45", 1, 1828, 2.36}}}},
    WaterlineCase{"carpet2",
                  .37,
                  .5,
                  {{{"cyl:3", 12, 1716, 0.97},
                    {"ball:3", 11, 1702, 1.31},
                    {"bull:3:0.75", 11, 1706, 3.17},
                    {"cone:3:45", 12, 1698, 1.39}}}},
};

std::optional<milling::TriangleMesh> MeshIn(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const auto raw = slicing::ReadMesh(bytes, MeshFormat::kUnknown, limits::kMaxMeshCoordinateMm, {});
  if (!raw.ok()) return std::nullopt;
  milling::TriangleMesh mesh;
  for (const Vector3& p : raw->positions) mesh.points_mm.push_back({p.x(), p.y(), p.z()});
  mesh.triangles = raw->triangles;
  return mesh;
}

/// Returns waves on 100 x 100 mm, up to 22 mm high.
milling::TriangleMesh Waves() {
  constexpr uint32_t kCells = 708;  // gives 1,002,528 triangles
  constexpr double kPitchMm = 100.0 / kCells;
  milling::TriangleMesh mesh;
  for (uint32_t j = 0; j <= kCells; ++j)
    for (uint32_t i = 0; i <= kCells; ++i) {
      const double x = i * kPitchMm, y = j * kPitchMm;
      mesh.points_mm.push_back(
          {x, y, 11 + 8 * std::sin(x / 7) * std::cos(y / 9) + 3 * std::sin(x + y)});
    }
  for (uint32_t j = 0; j < kCells; ++j)
    for (uint32_t i = 0; i < kCells; ++i) {
      const uint32_t a = j * (kCells + 1) + i, b = a + kCells + 1;
      mesh.triangles.push_back({a, a + 1, b});
      mesh.triangles.push_back({a + 1, b + 1, b});
    }
  return mesh;
}

struct TimedWaterline {
  size_t loops = 0;
  size_t points = 0;
  double seconds = 0;  ///< shortest time of some rounds
};

TimedWaterline Timed(const milling::TriangleMesh& mesh, const Cutter& cutter,
                     const std::vector<double>& levels_mm, double sampling_mm,
                     int rounds = kWaterlineRounds) {
  TimedWaterline timed{.seconds = 1e9};
  for (int round = 0; round < rounds; ++round) {
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

/// Returns `count` levels, evenly distributed over the height.
std::vector<double> LevelsOf(const milling::TriangleMesh& mesh, int count) {
  const auto by_z = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.z() < b.z();
  };
  const auto [lowest, highest] =
      std::minmax_element(mesh.points_mm.begin(), mesh.points_mm.end(), by_z);
  std::vector<double> levels;
  for (int i = 0; i < count; ++i)
    levels.push_back(lowest->z() + (i + 0.5) / count * (highest->z() - lowest->z()));
  return levels;
}

void BenchMillion() {
  const milling::TriangleMesh mesh = Waves();
  std::printf(
      "%zu triangles, %d levels, fibers every 0.1 mm: cutter | loops / points | s | points/s\n",
      mesh.triangles.size(), kLevelsOfMillion);
  for (const char* cutter : {"cyl:6", "ball:6", "bull:6:1"}) {
    const TimedWaterline all =
        Timed(mesh, *ParseCutter(cutter), LevelsOf(mesh, kLevelsOfMillion), 0.1, 1);
    std::printf("%s | %zu / %zu | %.1f | %.0f\n", cutter, all.loops, all.points, all.seconds,
                static_cast<double>(all.points) / all.seconds);
  }
}

void BenchModel(const WaterlineCase& model, const milling::TriangleMesh& mesh) {
  double low = mesh.points_mm[0].z(), high = low;
  for (const Eigen::Vector3d& p : mesh.points_mm)
    low = std::min(low, p.z()), high = std::max(high, p.z());
  const std::vector<double> many = LevelsOf(mesh, kManyLevels);
  for (const PeerWaterline& peer : model.peer) {
    const auto cutter = ParseCutter(peer.cutter);
    const TimedWaterline one =
        Timed(mesh, *cutter, {low + model.share * (high - low)}, model.sampling_mm);
    const TimedWaterline all = Timed(mesh, *cutter, many, model.sampling_mm);
    std::printf("%s | %zu | %s | %zu / %zu | %.1f | %.2f | %.0f | %d / %d | %.0f | %.0f | %.0f\n",
                model.file, mesh.triangles.size(), peer.cutter, one.loops, one.points,
                1e3 * one.seconds, 1e3 * all.seconds / kManyLevels,
                static_cast<double>(all.points) / all.seconds, peer.loops, peer.points,
                1e3 * peer.seconds, peer.seconds / one.seconds,
                peer.seconds * kManyLevels / all.seconds);
  }
}

}  // namespace

int BenchWaterline(const std::string& models) {
  std::printf(
      "model | triangles | cutter | loops / points | ms | ms a level of 50 | points/s | "
      "OpenCAMlib's loops / "
      "points | ms | times faster | of 50 levels\n");
  for (const WaterlineCase& model : kWaterlineCases) {
    const auto mesh = MeshIn(models + "/" + model.file + ".stl");
    if (mesh)
      BenchModel(model, *mesh);
    else
      std::fprintf(stderr, "%s.stl is not in %s\n", model.file, models.c_str());
  }
  BenchMillion();
  return 0;
}

}  // namespace slicefarm::bench
