#include "services/milling/algo/push/facet_push.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicefarm::milling {
namespace {

/// Computes the line in which a horizontal plane cuts a triangle. The plane is at `height` or
/// slightly above it, so that a triangle with its lowest side at `height` is cut along this side.
/// Returns false if the plane does not cut the triangle.
bool CutAt(double height, const std::array<FiberPoint, 3>& corners,
           std::array<FiberPoint, 2>& cut) {
  size_t found = 0;
  for (size_t k = 0; k < 3 && found < 2; ++k) {
    const FiberPoint *low = &corners[k], *high = &corners[(k + 1) % 3];
    if ((low->height <= height) == (high->height <= height)) continue;
    if (low->height > high->height) std::swap(low, high);
    const double s = (height - low->height) / (high->height - low->height);
    cut[found++] = {low->along + s * (high->along - low->along),
                    low->across + s * (high->across - low->across), height};
  }
  return found == 2;
}

}  // namespace

FacetNormal NormalOf(const std::array<FiberPoint, 3>& corners) {
  const FiberPoint& o = corners[0];
  const FiberPoint a{corners[1].along - o.along, corners[1].across - o.across,
                     corners[1].height - o.height};
  const FiberPoint b{corners[2].along - o.along, corners[2].across - o.across,
                     corners[2].height - o.height};
  const double along = a.across * b.height - a.height * b.across;
  const double across = a.height * b.along - a.along * b.height;
  const double up = a.along * b.across - a.across * b.along;
  const double flat = std::sqrt(along * along + across * across);
  const double length = std::sqrt(flat * flat + up * up);
  if (!(length > 0)) return {};
  const double factor = (up < 0 ? -1 : 1) / length;
  return {factor * along, factor * across, factor * up, flat / length};
}

FacetContact PushFacet(const Cutter& cutter, const std::array<FiberPoint, 3>& corners,
                       const FacetNormal& normal) {
  if (!(normal.flat > 0) || !(normal.up > 0) || normal.along == 0) return {};
  const double height = cutter.TouchHeight(normal.flat, normal.up);
  std::array<FiberPoint, 2> cut;
  if (!CutAt(height, corners, cut)) return {};
  const double width = cutter.Width(height);
  const double across = -width * (normal.across / normal.flat);
  const auto [low, high] = std::minmax(cut[0].across, cut[1].across);
  if (!(across >= low && across <= high && low < high)) return {};
  const double s = (across - cut[0].across) / (cut[1].across - cut[0].across);
  const double along = cut[0].along + s * (cut[1].along - cut[0].along);
  return {.side = static_cast<int8_t>(normal.along > 0 ? 1 : -1),
          .end = along + width * (normal.along / normal.flat),
          .at = {along, across, height}};
}

}  // namespace slicefarm::milling
