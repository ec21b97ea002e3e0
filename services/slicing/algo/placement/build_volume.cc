#include "services/slicing/algo/placement/build_volume.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "absl/strings/escaping.h"
#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/offset.h"
#include "common/model/limits.h"

namespace slicefarm::slicing {
namespace {

std::string SizeText(const Box& box) {
  return fmt::format("{:.3f} x {:.3f} mm", ToMm(static_cast<double>(box.max.x - box.min.x)),
                     ToMm(static_cast<double>(box.max.y - box.min.y)));
}

std::string Quoted(std::string_view name) {
  return absl::StrCat("\"", absl::Utf8SafeCEscape(std::string(name)), "\"");
}

/// Returns the footprint grown by `grow_nm`. It contains the object's grown outlines in all layers.
Polygon Grown(const Polygon& hull, Coord grow_nm) {
  if (grow_nm <= 0) return hull;
  const MultiPolygon grown = Offset({{hull, {}}}, grow_nm);
  return grown.empty() ? hull : grown[0].outer;
}

double DistanceToRing(Point p, const Polygon& ring) {
  double nearest = DistanceToSegment(p, ring.back(), ring.front());
  for (size_t i = 1; i < ring.size(); ++i)
    nearest = std::min(nearest, DistanceToSegment(p, ring[i - 1], ring[i]));
  return nearest;
}

/// Returns the distance by which the farthest of `points`, moved by `shift`, is outside the bed; 0
/// if all are within.
double ExcessNm(const Polygon& points, Point shift, const Polygon& bed) {
  double excess = 0;
  for (const Point p : points)
    if (Locate(p + shift, bed) == Side::kOutside)
      excess = std::max(excess, DistanceToRing(p + shift, bed));
  return excess;
}

absl::Status BedError(std::string_view name, const Box& part, const Polygon& bed, double excess) {
  const Box bed_box = Bounds(bed);
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfBuildVolume,
                   fmt::format("{} reaches {:.3f} mm beyond the edge of the bed (part {}, bed {})",
                               Quoted(name), ToMm(excess), SizeText(part), SizeText(bed_box)),
                   {{"object", std::string(name)},
                    {"excess_mm", fmt::format("{:.3f}", ToMm(excess))},
                    {"limit", SizeText(bed_box)},
                    {"got", SizeText(part)}});
}

absl::Status ExcludedError(std::string_view name, const Box& part, const Polygon& area,
                           std::string_view setting) {
  const Box box = Bounds(area);
  const auto corner = [](Point p) {
    return fmt::format("{:.3f}, {:.3f}", ToMm(static_cast<double>(p.x)),
                       ToMm(static_cast<double>(p.y)));
  };
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfBuildVolume,
                   fmt::format("{} reaches into an excluded area of the bed ({}, {} to {} mm): "
                               "move it elsewhere",
                               Quoted(name), setting, corner(box.min), corner(box.max)),
                   {{"object", std::string(name)},
                    {"setting", std::string(setting)},
                    {"limit", SizeText(box)},
                    {"got", SizeText(part)}});
}

absl::Status HeightError(std::string_view name, Coord height, Coord limit) {
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kOutOfBuildVolume,
      fmt::format("{} is {:.3f} mm high, {:.3f} mm more than max_print_height", Quoted(name),
                  ToMm(static_cast<double>(height)), ToMm(static_cast<double>(height - limit))),
      {{"object", std::string(name)},
       {"excess_mm", fmt::format("{:.3f}", ToMm(static_cast<double>(height - limit)))},
       {"limit", fmt::format("{:.3f} mm", ToMm(static_cast<double>(limit)))},
       {"got", fmt::format("{:.3f} mm", ToMm(static_cast<double>(height)))}});
}

bool InRange(const Box& box, Point center) {
  return std::max({box.max.x + center.x, box.max.y + center.y, -(box.min.x + center.x),
                   -(box.min.y + center.y)}) <= limits::kMaxCoord;
}

absl::Status CentersError(std::string_view name) {
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kOutOfRange,
      fmt::format("{} is placed more than {:.3f} mm from the origin", Quoted(name),
                  ToMm(limits::kMaxCoord)),
      {{"object", std::string(name)}, {"limit", fmt::format("{:.3f}", ToMm(limits::kMaxCoord))}});
}

}  // namespace

Point BedCenter(const Polygon& bed) {
  if (bed.empty()) return {};
  const Box box = Bounds(bed);
  return {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

bool MeetsExcluded(const Polygon& footprint, Point shift, Coord grow_nm,
                   const std::vector<Polygon>& excluded) {
  if (excluded.empty() || footprint.size() < 3) return false;
  const Polygon hull = Moved(Grown(footprint, grow_nm), shift);
  return std::ranges::any_of(excluded, [&](const Polygon& area) {
    return Bounds(hull).Intersects(Bounds(area)) &&
           !Intersection({{hull, {}}}, Union({&area, 1}, FillRule::kNonZero)).empty();
  });
}

absl::Status CheckBuildVolume(const Bulk& bulk, std::string_view name,
                              const std::vector<Point>& centers, const SlicingOptions& options) {
  if (options.max_print_height_nm > 0 && bulk.top_nm > options.max_print_height_nm)
    return HeightError(name, bulk.top_nm, options.max_print_height_nm);
  if (bulk.footprint.empty()) return absl::OkStatus();
  const Polygon hull = Grown(bulk.footprint, bulk.xy_compensation_nm);
  const Box box = Bounds(hull);
  for (const Point center : centers) {
    // Sums with coordinates of far centres would overflow.
    constexpr Coord kFar = 2 * limits::kMaxCoord;
    const bool near = std::abs(center.x) <= kFar && std::abs(center.y) <= kFar;
    if (!near || !InRange(box, center)) return CentersError(name);
    for (const auto& [areas, setting] : {std::pair(&options.excluded, "bed_exclude_area"),
                                         std::pair(&options.wrapping, "wrapping_exclude_area")})
      for (const Polygon& area : *areas)
        if (MeetsExcluded(hull, center, 0, {area})) return ExcludedError(name, box, area, setting);
    if (options.bed.size() < 3) continue;
    const double excess = ExcessNm(hull, center, options.bed);
    if (excess > 0) return BedError(name, box, options.bed, excess);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::slicing
