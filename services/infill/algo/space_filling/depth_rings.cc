#include "services/infill/algo/space_filling/depth_rings.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/limits.h"

namespace slicefarm::infill {
namespace {

constexpr double kShortestRing = 1.5;  ///< least length of a ring, in spacings
/// Divisor of the spacing: beyond the first step, a line is omitted where its two sides are nearer
/// to each other than twice the quotient.
constexpr Coord kNarrowestPart = 20;

/// Returns true if nothing is left of an island at this depth, judged by its box.
bool IsThin(const PolygonWithHoles& island, Coord depth) {
  const Box box = Bounds(island.outer);
  return std::min(box.max.x - box.min.x, box.max.y - box.min.y) <= 2 * depth;
}

}  // namespace

std::vector<StepRing> RingsFrom(MultiPolygon region, Coord spacing_nm) {
  std::vector<StepRing> rings;
  for (int32_t step = 0; !region.empty(); ++step) {
    ForEachRing(region, [&](const Polygon& ring) {
      if (Perimeter(ring) >= kShortestRing * static_cast<double>(spacing_nm))
        rings.push_back({ring, step});
    });
    const Coord narrow = spacing_nm / kNarrowestPart;
    std::erase_if(region, [&](const auto& island) { return IsThin(island, spacing_nm + narrow); });
    region = FastOffset(FastOffset(region, -(spacing_nm + narrow)), narrow);
  }
  return rings;
}

absl::Status CheckRingSpacing(const PolygonWithHoles& region, Coord spacing_nm) {
  if (spacing_nm <= 0) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                     absl::StrCat("lines ", spacing_nm, " nm apart: must be above 0"),
                     {{"got", absl::StrCat(spacing_nm)}});
  }
  const Box box = Bounds(region.outer);
  if (box.Empty()) return absl::OkStatus();
  const auto columns = (box.max.x - box.min.x) / spacing_nm + 1;
  const auto rows = (box.max.y - box.min.y) / spacing_nm + 1;
  if (columns > limits::kMaxPointsPerLayer / rows) {
    return LimitError(Reason::kRequestTooLarge,
                      "line spacings squared in the box of an infill region",
                      limits::kMaxPointsPerLayer, columns * rows);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::infill
