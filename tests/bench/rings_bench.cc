#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "services/exposure/algo/scan/coverage_test.h"
#include "services/exposure/algo/scan/ring_scan.h"
#include "services/exposure/algo/scan/scan_pieces.h"
#include "services/lab/poly_files.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/polygon_folder.h"

namespace slicefarm::bench {
namespace {

/// Smallest step of the raster for areas. It is no divisor of the hatch distance, because lines are
/// on a raster too. The second constant is the largest number of raster points.
constexpr Coord kLeastStepNm = 17'011;
constexpr double kMostPoints = 3e5;
/// Reduction of the spot for the area melted twice. Neighbouring rings touch, and this must not
/// count as twice.
constexpr Coord kTouchNm = 2'000;

/// Converts coordinates of a file in mm to nm.
MultiPolygon InNm(MultiPolygon islands, int decimals) {
  double nm = kNmPerMm;
  for (int i = 0; i < decimals; ++i) nm /= 10;
  const auto apply = [nm](Polygon& ring) {
    for (Point& p : ring) {
      p = {std::llround(static_cast<double>(p.x) * nm),
           std::llround(static_cast<double>(p.y) * nm)};
    }
  };
  for (PolygonWithHoles& island : islands) {
    apply(island.outer);
    for (Polygon& hole : island.holes) apply(hole);
  }
  return islands;
}

Coord StepFor(const MultiPolygon& region) {
  const Box box = Bounds(region);
  const double area =
      static_cast<double>(box.max.x - box.min.x) * static_cast<double>(box.max.y - box.min.y);
  return std::max<Coord>(kLeastStepNm, std::llround(std::sqrt(area / kMostPoints)));
}

struct Coverage {
  double of_area = 0;       ///< melted share of the outline
  double of_reachable = 0;  ///< melted share of the area that a spot can melt within the outline
  double twice_nm2 = 0;     ///< area melted by two pieces
  double cuts_nm = 0;       ///< length of all cuts
};

/// Returns the length of all cuts.
double CutLength(const MultiPolygon& region, const ExposureOptions& options) {
  const auto pieces = exposure::ScanPieces(region, options.decompose, 0, {});
  if (!pieces.ok()) return 0;
  double length = 0;
  for (const Polygon& piece : pieces->pieces)
    length += Perimeter(piece) / static_cast<double>(pieces->scale);
  ForEachRing(region, [&](const Polygon& ring) { length -= Perimeter(ring); });
  return length / 2;
}

absl::StatusOr<Coverage> Covered(const MultiPolygon& region, const ExposureOptions& options) {
  ExposureGroup group;
  CutCounts counts;
  const absl::Status status = exposure::ScanByRings(region, options, 0, {}, {}, group, counts);
  if (!status.ok()) return status;
  const Coord reach = options.spot_nm / 2;
  const MultiPolygon reachable =
      OffsetTwice(region, -reach, reach, {.join = Join::kRound, .arc_tolerance_nm = 100});
  const Coord step = StepFor(region);
  exposure::MeltedRaster all(region, step), open(reachable, step), twice(region, step);
  group.ForEachLine([&](std::span<const Point> line) {
    all.Add(line, options.spot_nm);
    open.Add(line, options.spot_nm);
    twice.Add(line, options.spot_nm - kTouchNm);
  });
  return Coverage{all.Share(1), open.Share(1), twice.Share(2) * Area(region),
                  CutLength(region, options)};
}

/// Shares of regions: the smallest one, the mean weighted by area, and the number of shares below
/// 0.995.
class Shares {
 public:
  void Add(double share, double area) {
    least_ = std::min(least_, share);
    sum_ += share * area;
    area_ += area;
    below_ += share < 0.995 ? 1 : 0;
  }
  void Print(const char* name) const {
    std::printf("%s_mean %.5f\n%s_least %.5f\n%s_below_995 %d\n", name, sum_ / area_, name, least_,
                name, below_);
  }

 private:
  double least_ = 1, sum_ = 0, area_ = 0;
  int below_ = 0;
};

/// Measures all files with one scan strategy.
class RingRun {
 public:
  explicit RingRun(const ExposureOptions& options) : options_(options) {}

  void Add(const PolygonFile& file) {
    const MultiPolygon region = InNm(file.poly.islands, file.poly.decimals);
    const auto coverage = Covered(region, options_);
    if (!coverage.ok()) {
      std::printf("%s failed: %s\n", file.name.c_str(),
                  std::string(coverage.status().message()).c_str());
      return;
    }
    of_area_.Add(coverage->of_area, Area(region));
    of_reachable_.Add(coverage->of_reachable, Area(region));
    twice_nm2_ += coverage->twice_nm2;
    cuts_nm_ += coverage->cuts_nm;
    area_nm2_ += Area(region);
  }

  void Print() const {
    std::printf("corners %d overlap_um %.0f\n", options_.fill_corners ? 1 : 0,
                static_cast<double>(options_.ring_overlap_nm) / 1000);
    of_area_.Print("area");
    of_reachable_.Print("reachable");
    std::printf("twice_share %.5f\ntwice_along_cuts_um %.3f\n", twice_nm2_ / area_nm2_,
                twice_nm2_ / cuts_nm_ / 1000);
  }

 private:
  const ExposureOptions options_;
  Shares of_area_, of_reachable_;
  double twice_nm2_ = 0, cuts_nm_ = 0, area_nm2_ = 0;
};

}  // namespace

int BenchRings(const std::string& outlines) {
  const std::vector<PolygonFile> files = PolygonsIn(outlines);
  for (const bool corners : {true, false}) {
    for (const Coord overlap : {0, 20'000}) {
      ExposureOptions options;
      options.strategy = ScanStrategy::kRings;
      options.fill_corners = corners;
      options.ring_overlap_nm = overlap;
      RingRun run(options);
      for (const PolygonFile& file : files) run.Add(file);
      run.Print();
    }
  }
  return 0;
}

}  // namespace slicefarm::bench
