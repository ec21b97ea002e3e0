#include "services/milling/algo/strategy/free_area.h"

#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/rings/simplify.h"
#include "services/milling/algo/strategy/plane.h"
#include "services/milling/algo/waterline/waterline.h"

namespace slicefarm::milling {
namespace {

/// Shares of the tolerance, for waterlines and for removing points of straight walls. The remaining
/// share is for arcs.
constexpr double kWaterlineShare = 0.15;
constexpr double kStraightShare = 0.1;

MultiPolygon RegionOf(const std::vector<WaterlineLoop>& loops, double tolerance_mm) {
  std::vector<Polygon> rings;
  for (const WaterlineLoop& loop : loops) {
    Polygon ring;
    for (const Eigen::Vector2d& p : loop.points_mm) ring.push_back(PointOf(p));
    rings.push_back(SimplifyRing(ring, FromMm(kStraightShare * tolerance_mm)));
  }
  return Union(rings, FillRule::kPositive);
}

absl::StatusOr<std::vector<MultiPolygon>> GougedRegions(const TriangleMesh& mesh,
                                                        const Cutter& cutter,
                                                        std::span<const double> levels_mm,
                                                        const MillingOptions& options,
                                                        const CancelToken& cancel, int threads) {
  const WaterlineOptions how{.sampling_mm = options.sampling_mm,
                             .tolerance_mm = kWaterlineShare * options.tolerance_mm,
                             .threads = threads};
  const auto levels = Waterlines(mesh, cutter, levels_mm, how, cancel);
  if (!levels.ok()) return levels.status();
  std::vector<MultiPolygon> regions;
  for (const std::vector<WaterlineLoop>& loops : *levels) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    regions.push_back(RegionOf(loops, options.tolerance_mm));
  }
  return regions;
}

}  // namespace

absl::StatusOr<std::vector<FreeArea>> FreeAreas(const MillingJob& job, double allowance_mm,
                                                std::span<const double> levels_mm,
                                                const CancelToken& cancel, int threads) {
  const MillingOptions& options = job.options;
  const auto wide =
      Cutter::Cylinder(2 * (options.cutter.radius_mm() + options.machining.clearance_mm));
  if (!wide.ok()) return wide.status();
  const auto reach = GougedRegions(job.stock, *wide, levels_mm, options, cancel, threads);
  if (!reach.ok()) return reach.status();
  const GrownCutter grown = options.cutter.Grown(allowance_mm);
  std::vector<double> tips_mm;
  for (const double z : levels_mm) tips_mm.push_back(z + grown.tip_mm);
  const auto part = GougedRegions(job.part, grown.cutter, tips_mm, options, cancel, threads);
  if (!part.ok()) return part.status();
  std::vector<FreeArea> areas;
  for (size_t i = 0; i < levels_mm.size(); ++i) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    MultiPolygon free = Difference((*reach)[i], (*part)[i]);
    areas.push_back({(*reach)[i], std::move(free)});
  }
  return areas;
}

}  // namespace slicefarm::milling
