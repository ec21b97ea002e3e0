#include "services/planning/algo/conflicts/meeting.h"

#include <fmt/core.h>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"

namespace slicefarm::planning {

std::optional<Point> MeetingOf(const MultiPolygon& a, const MultiPolygon& b) {
  if (a.empty() || b.empty() || !Bounds(a).Intersects(Bounds(b))) return std::nullopt;
  const MultiPolygon shared = Intersection(a, b);
  if (shared.empty()) return std::nullopt;
  const MultiPolygon wide = Offset(shared, -kSharedWidthNm / 2);
  if (wide.empty()) return std::nullopt;
  return wide.front().outer.front();
}

absl::Status ConflictError(const std::string& first, const std::string& second, Point place,
                           Coord z_nm) {
  const auto mm = [](Coord nm) { return fmt::format("{:.2f}", ToMm(nm)); };
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kPathsConflict,
      fmt::format("{} and {} share room at ({}, {}), {} mm above the bed. Move them apart, or make "
                  "them one object; objects_may_overlap = 1 prints them through each other",
                  first, second, mm(place.x), mm(place.y), mm(z_nm)),
      {{"first", first},
       {"second", second},
       {"x_mm", mm(place.x)},
       {"y_mm", mm(place.y)},
       {"z_mm", mm(z_nm)}});
}

}  // namespace slicefarm::planning
