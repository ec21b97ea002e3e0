#include "common/model/fields/field_grid.h"

#include <algorithm>
#include <cmath>

namespace slicefarm {
namespace {

/// Nodes below and above a position along one axis, and the position's relative distance to the
/// upper node.
struct Between {
  int64_t below = 0;
  int64_t above = 0;
  double share = 0;
};

Between Locate(double position, double origin, double spacing, int32_t count) {
  const double at = std::clamp((position - origin) / spacing, 0.0, static_cast<double>(count - 1));
  const auto below = static_cast<int64_t>(std::floor(at));
  return {below, std::min<int64_t>(below + 1, count - 1), at - static_cast<double>(below)};
}

double Mix(double a, double b, double share) { return a + (b - a) * share; }

}  // namespace

double FieldGrid::At(const PositionMm& position_mm) const {
  std::array<Between, 3> at;
  for (size_t i = 0; i < 3; ++i)
    at[i] = Locate(position_mm[i], origin_mm[i], spacing_mm[i], count[i]);
  const auto row = [&](int64_t y, int64_t z) {
    const int64_t first = (z * count[1] + y) * count[0];
    return Mix(values[static_cast<size_t>(first + at[0].below)],
               values[static_cast<size_t>(first + at[0].above)], at[0].share);
  };
  const auto sheet = [&](int64_t z) {
    return Mix(row(at[1].below, z), row(at[1].above, z), at[1].share);
  };
  return Mix(sheet(at[2].below), sheet(at[2].above), at[2].share);
}

bool SameNodes(const FieldGrid& a, const FieldGrid& b) {
  return a.count == b.count && a.origin_mm == b.origin_mm && a.spacing_mm == b.spacing_mm;
}

}  // namespace slicefarm
