#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "services/exposure/algo/decompose/decompose.h"
#include "services/exposure/algo/decompose/piece_quality.h"
#include "services/exposure/algo/expose_layer.h"
#include "services/exposure/algo/writers/writers.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/lattice.h"
#include "tests/bench/polygon_folder.h"
#include "tests/bench/thread_seconds.h"

namespace slicefarm::bench {
namespace {

using exposure::ConvexPieces;
using exposure::DecomposeOptions;

constexpr int kRounds = 5;
/// Largest region for CGAL's optimal partition, which takes minutes above this.
constexpr size_t kMaxOptimalPoints = 150;
constexpr int kLatticeCells = 22;
constexpr int kLatticeLayers = 100;

struct Timed {
  absl::StatusOr<ConvexPieces> pieces;
  double seconds = 0;
};

/// Returns the pieces, and the shortest time of some rounds.
Timed Decomposed(const MultiPolygon& islands, DecomposeMethod method) {
  Timed timed{absl::UnknownError(""), std::numeric_limits<double>::infinity()};
  const DecomposeOptions options = {.method = method,
                                    .merge_nm = std::numeric_limits<double>::infinity()};
  for (int round = 0; round < kRounds; ++round) {
    const double start = ThreadSeconds();
    timed.pieces = exposure::Decompose(islands, options);
    timed.seconds = std::min(timed.seconds, ThreadSeconds() - start);
    if (timed.seconds > 0.5) break;
  }
  return timed;
}

std::string Cell(const Timed& timed) {
  if (!timed.pieces.ok()) return "failed";
  double worst = 0;
  for (const Polygon& piece : timed.pieces->pieces)
    worst = std::max(worst, exposure::ShapeFactor(piece));
  char text[80];
  std::snprintf(text, sizeof text, "%zu / %.1f / %.2f", timed.pieces->pieces.size(), worst,
                1e3 * timed.seconds);
  return text;
}

int BenchPolygons(const std::string& directory) {
  const std::vector<PolygonFile> files = PolygonsIn(directory);
  if (files.empty()) {
    std::fprintf(stderr, "no polygons in %s\n", directory.c_str());
    return 1;
  }
  std::printf(
      "polygon | corners | reflex | bian: pieces / worst shape / ms | optimal | approximate | "
      "ymonotone\n");
  for (const PolygonFile& file : files) {
    const size_t points = PointCount(file.poly.islands);
    const Timed bian = Decomposed(file.poly.islands, DecomposeMethod::kBian);
    std::printf("%s | %zu | %lld | %s | %s | %s | %s\n", file.name.c_str(), points,
                bian.pieces.ok() ? static_cast<long long>(bian.pieces->counts.reflex) : -1,
                Cell(bian).c_str(),
                points > kMaxOptimalPoints
                    ? "-"
                    : Cell(Decomposed(file.poly.islands, DecomposeMethod::kOptimal)).c_str(),
                Cell(Decomposed(file.poly.islands, DecomposeMethod::kApproximate)).c_str(),
                Cell(Decomposed(file.poly.islands, DecomposeMethod::kYMonotone)).c_str());
  }
  return 0;
}

/// Prints the vectors per second of one core for the whole layer, or for its hatch or rings alone.
void BenchStrategy(const char* name, ScanStrategy strategy, bool inside_only) {
  ExposureOptions options;
  options.strategy = strategy;
  if (inside_only) {
    options.contours = 0;
    options.beam_compensation_nm = 0;
    options.thin_walls = false;
  }
  const std::vector<ExposureOptions> regions = {options};
  const std::vector<Copy> copies(1);
  double seconds = 0, write_seconds = 0, megabytes = 0;
  int64_t vectors = 0;
  exposure::FileFacts facts;
  facts.regions = regions;
  facts.output.format = OutputFormat::kCliBinary;
  for (int32_t index = 0; index < kLatticeLayers; ++index) {
    const std::vector<SlicedLayer> layers = {LatticeLayer(index, kLatticeLayers, kLatticeCells)};
    const ObjectLayers objects(layers);
    const double start = ThreadSeconds();
    const auto layer = exposure::ExposeLayer(layers[0], objects, regions, copies, {});
    seconds += ThreadSeconds() - start;
    if (!layer.ok()) {
      std::printf("%s failed: %s\n", name, std::string(layer.status().message()).c_str());
      return;
    }
    vectors += exposure::ReportOf(*layer, regions).Total().vectors;
    const double write_start = ThreadSeconds();
    megabytes += 1e-6 * static_cast<double>(exposure::LayerText(*layer, facts).size());
    write_seconds += ThreadSeconds() - write_start;
  }
  const char* part = inside_only ? "inside" : "layer";
  std::printf("%s_%s_vectors %lld\n%s_%s_million_vectors_per_s %.2f\n%s_%s_cli_mb_per_s %.0f\n",
              name, part, static_cast<long long>(vectors), name, part,
              1e-6 * static_cast<double>(vectors) / seconds, name, part, megabytes / write_seconds);
}

}  // namespace

int BenchExposure(const std::string& polygons) {
  for (const bool inside_only : {true, false}) {
    BenchStrategy("hatch", ScanStrategy::kHatch, inside_only);
    BenchStrategy("stripes", ScanStrategy::kStripes, inside_only);
    BenchStrategy("islands", ScanStrategy::kIslands, inside_only);
    BenchStrategy("rings", ScanStrategy::kRings, inside_only);
  }
  return BenchPolygons(polygons);
}

}  // namespace slicefarm::bench
