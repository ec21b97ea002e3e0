#include "services/motion/algo/toolpath/surface_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/base/portable_math.h"
#include "common/geometry/between.h"
#include "common/geometry/measure.h"
#include "services/motion/algo/toolpath/feature_groups.h"
#include "services/motion/algo/toolpath/path_segment.h"

namespace slicefarm::motion {
namespace {

/// Distance of the points at which the surface is measured.
constexpr double kSampleNm = 100'000;
/// Largest difference between the height of the nozzle and the measured height between two points.
constexpr double kToleranceNm = 2'000;
/// Depth by which the nozzle may dip below printed beads beside it: it smooths them, like the next
/// wall of a level layer that is slightly too high.
constexpr Coord kDipNm = 50'000;
/// Length of a path behind the nozzle that is still soft and belongs to the bead being printed.
constexpr double kSoftNm = 1'500'000;
/// Distance from the surface, in nozzle diameters, beyond which beads have no effect on paths that
/// follow it. It is more than the radius of the tip and the layer's height together.
constexpr Coord kReachNozzles = 5;

/// Returns true for features that follow the surface.
bool FollowsSurface(const Path& path) {
  return IsTop(path.feature) || path.feature == Feature::kExternalPerimeter ||
         path.feature == Feature::kPerimeter;
}

}  // namespace

SurfaceFollower::SurfaceFollower(std::span<const SurfaceFacet> facets, Coord height_nm,
                                 Coord nozzle_nm)
    : height_nm_(height_nm),
      reach_nm_(kReachNozzles * nozzle_nm),
      surface_(facets, reach_nm_),
      printed_(nozzle_nm + nozzle_nm / 2) {}

Coord SurfaceFollower::WantedUp(Point point, Coord width_nm, Feature feature,
                                const RegionMotion& region) const {
  const auto lowest_nm = static_cast<double>(-height_nm_);
  const auto place = surface_.At(point, lowest_nm, 0);
  if (!place) return 0;
  double up_nm = place->up_nm;
  const double edge_slope = region.contour_edge_slope_rad;
  if (IsWall(feature) && edge_slope > 0 && place->slope_rad > edge_slope)
    up_nm -= static_cast<double>(width_nm) / 2 * Sin(place->slope_rad);
  return std::llround(std::clamp(
      up_nm, std::min(0.0, lowest_nm + static_cast<double>(region.contour_least_nm)), 0.0));
}

void SurfaceFollower::AppendSamples(const PathSegment& segment, Feature feature,
                                    const RegionMotion& region,
                                    std::vector<Sample>& samples) const {
  const double length = Distance(segment.from, segment.to);
  const auto pieces = [](double of_nm, double size_nm) {
    return std::max<int64_t>(1, std::llround(std::ceil(of_nm / size_nm)));
  };
  const int64_t strides = pieces(length, static_cast<double>(reach_nm_) / 2);
  const int64_t steps = pieces(length / static_cast<double>(strides), kSampleNm);
  const auto at = [&](double share) { return PointBetween(segment.from, segment.to, share); };
  for (int64_t stride = 0; stride < strides; ++stride) {
    const auto all = static_cast<double>(strides * steps);
    const bool near =
        surface_.IsNear(at((static_cast<double>(stride) + 0.5) / static_cast<double>(strides)));
    for (int64_t step = near ? 1 : steps; step <= steps; ++step) {
      const bool corner = stride + 1 == strides && step == steps;
      const Point point =
          corner ? segment.to : at(static_cast<double>(stride * steps + step) / all);
      const Coord up = near ? WantedUp(point, segment.width_nm, feature, region) : 0;
      samples.push_back({{point, segment.width_nm, up}, corner, near});
    }
  }
}

std::vector<SurfaceFollower::Sample> SurfaceFollower::SamplesOf(const Path& path,
                                                                const RegionMotion& region) const {
  const PathSegment first = SegmentOf(path, 0);
  std::vector<Sample> samples = {
      {{first.from, first.width_nm, WantedUp(first.from, first.width_nm, path.feature, region)},
       true,
       surface_.IsNear(first.from)}};
  for (size_t i = 0; i < SegmentsOf(path); ++i)
    AppendSamples(SegmentOf(path, i), path.feature, region, samples);
  return samples;
}

void SurfaceFollower::Print(const Sample& sample) {
  if (sample.near) printed_.Add(sample.at.point, sample.at.up_nm);
}

/// Raises samples to the height that the printed beads allow, and adds the path to them.
void SurfaceFollower::RaiseOverPrinted(const RegionMotion& region, std::vector<Sample>& samples) {
  const Coord lowest_nm = std::min<Coord>(0, region.contour_least_nm - height_nm_);
  size_t hard = 0;  // samples before it are hard
  double behind_nm = 0;
  for (size_t i = 0; i < samples.size(); ++i) {
    ContourPoint& at = samples[i].at;
    if (i > 0) behind_nm += Distance(samples[i - 1].at.point, at.point);
    for (; behind_nm > kSoftNm && hard < i; ++hard) {
      Print(samples[hard]);
      behind_nm -= Distance(samples[hard].at.point, samples[hard + 1].at.point);
    }
    if (at.up_nm < -kDipNm)
      at.up_nm = std::max(at.up_nm, printed_.LeastUp(at.point, lowest_nm) - kDipNm);
  }
  for (; hard < samples.size(); ++hard) Print(samples[hard]);
}

/// Leaves out samples on straight edges between which the height changes evenly, within the
/// tolerance.
std::vector<ContourPoint> SurfaceFollower::Thinned(std::span<const Sample> samples) {
  std::vector<ContourPoint> kept = {samples.front().at};
  size_t first = 0, last = 0;
  double least = -std::numeric_limits<double>::infinity(), most = -least;
  const auto rise = [&](size_t to, double by) {
    const auto up = static_cast<double>(samples[to].at.up_nm - samples[first].at.up_nm);
    return (up + by) / std::max(1.0, Distance(samples[first].at.point, samples[to].at.point));
  };
  const auto keep = [&](size_t i) {
    kept.push_back(samples[i].at);
    first = last = i;
    least = -std::numeric_limits<double>::infinity(), most = -least;
  };
  for (size_t i = 1; i < samples.size(); ++i) {
    if (last > first && (rise(i, 0) < least || rise(i, 0) > most)) keep(last);
    last = i;
    least = std::max(least, rise(i, -kToleranceNm));
    most = std::min(most, rise(i, kToleranceNm));
    if (samples[i].corner) keep(i);
  }
  return kept;
}

std::vector<ContourPoint> SurfaceFollower::Follow(const Path& path, const RegionMotion& region) {
  std::vector<Sample> samples = SamplesOf(path, region);
  if (region.contour_least_nm <= 0 || !FollowsSurface(path))
    for (Sample& sample : samples) sample.at.up_nm = 0;
  RaiseOverPrinted(region, samples);
  const auto is_level = [](const Sample& sample) { return sample.at.up_nm == 0; };
  if (std::ranges::all_of(samples, is_level)) return {};
  return Thinned(samples);
}

}  // namespace slicefarm::motion
