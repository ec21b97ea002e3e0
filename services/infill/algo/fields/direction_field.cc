#include "services/infill/algo/fields/direction_field.h"

#include <algorithm>
#include <cmath>
#include <vector>


namespace slicefarm::infill {
namespace {

/// One pass of 1/4, 1/2, 1/4 along each axis; at the ends the outer node counts twice.
void Smooth(FieldGrid& grid) {
  int64_t stride = 1;
  for (size_t axis = 0; axis < 3; ++axis) {
    const int64_t count = grid.count[axis];
    const std::vector<double> before = grid.values;
    for (int64_t i = 0; i < std::ssize(before); ++i) {
      const int64_t at = i / stride % count;
      const auto value = [&](int64_t step) {
        return before[static_cast<size_t>(at + step < 0 || at + step >= count ? i
                                                                              : i + step * stride)];
      };
      grid.values[static_cast<size_t>(i)] = (value(-1) + 2 * value(0) + value(1)) / 4;
    }
    stride *= count;
  }
}

}  // namespace

DirectionField::DirectionField(const StressField& stress) : cos2_(stress.xx), sin2_(stress.xx) {
  double greatest = 0;
  for (size_t i = 0; i < cos2_.values.size(); ++i) {
    cos2_.values[i] = stress.xx.values[i] - stress.yy.values[i];
    sin2_.values[i] = 2 * stress.xy.values[i];
    greatest = std::max({greatest, std::abs(cos2_.values[i]), std::abs(sin2_.values[i])});
  }
  for (size_t i = 0; i < cos2_.values.size(); ++i) {
    double &c = cos2_.values[i], &s = sin2_.values[i];
    if (greatest > 0) c /= greatest, s /= greatest;
    const double length = std::sqrt(c * c + s * s);
    const bool alike = length < kAlike;
    c = alike ? 0 : c / length;
    s = alike ? 0 : s / length;
  }
  for (int32_t pass = 0; pass < stress.smoothing; ++pass) Smooth(cos2_), Smooth(sin2_);
}

std::optional<Direction> DirectionField::At(const PlaceMm& place_mm) const {
  const double c = cos2_.At(place_mm), s = sin2_.At(place_mm);
  if (c * c + s * s < kLeastLength * kLeastLength) return std::nullopt;
  // Half the angle, by the formula that loses no digits on its side.
  const double length = std::sqrt(c * c + s * s);
  if (c >= 0) {
    const double x = std::sqrt((1 + c / length) / 2);
    return Direction{x, s / length / (2 * x)};
  }
  const double y = std::sqrt((1 - c / length) / 2);
  return Direction{s / length / (2 * y), y};
}

}  // namespace slicefarm::infill
