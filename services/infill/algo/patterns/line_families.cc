#include "services/infill/algo/patterns/line_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace slicefarm::infill {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kThirdTurn = 2 * std::numbers::pi / 3;

/// Returns three directions that sum to zero. `shift_nm`: distance of each family from the origin,
/// to the left of its direction.
std::vector<LineFamily> ThreeWays(const PatternPlace& place,
                                  const std::array<double, 3>& shift_nm) {
  std::vector<LineFamily> families;
  for (size_t i = 0; i < 3; ++i)
    families.push_back(
        {place.angle_rad + static_cast<double>(i) * kThirdTurn, shift_nm[i], 3 * place.pitch_nm});
  return families;
}

/// Returns the distance of each family of a pair from the middle between both, at a height. It
/// rises and falls by height / sqrt 2. The lines of both families stay a spacing apart.
double PairShift(const PatternPlace& place, double height_nm, double apart_nm) {
  const double turns = height_nm / std::numbers::sqrt2 / apart_nm;
  const double phase = turns - std::floor(turns);
  const double half = static_cast<double>(place.spacing_nm) / 2;
  const double shift = std::min(phase, 1 - phase) * apart_nm;
  return std::max(half, std::min(shift, apart_nm / 2 - half));
}

/// Returns the sections of four families of planes, inclined to all sides: two directions with a
/// pair of families each. The planes of one direction are a quarter of a period in z above the
/// planes of the other direction. So they enclose regular tetrahedra and tetrahedra with cut
/// corners.
std::vector<LineFamily> QuarterCubicFamilies(const PatternPlace& place) {
  const double apart = 4 * place.pitch_nm;
  const auto z = static_cast<double>(place.z_nm);
  const double quarter = std::numbers::sqrt2 * apart / 4;
  const double first = PairShift(place, z, apart), second = PairShift(place, z + quarter, apart);
  return {{place.angle_rad, first, apart},
          {place.angle_rad, -first, apart},
          {place.angle_rad + kRightAngle, second, apart},
          {place.angle_rad + kRightAngle, -second, apart}};
}

}  // namespace

std::vector<LineFamily> LineFamiliesOf(FillPattern pattern, const PatternPlace& place) {
  switch (pattern) {
    case FillPattern::kAlignedRectilinear:
    case FillPattern::kZigzag:
      return {{place.angle_rad, 0, place.pitch_nm}};
    case FillPattern::kRectilinear:
    case FillPattern::kLine:
    case FillPattern::kMonotonic:
    case FillPattern::kMonotonicLines:
      return {{place.layer % 2 != 0 ? place.angle_rad + kRightAngle : place.angle_rad, 0,
               place.pitch_nm}};
    case FillPattern::kGrid:
      return {{place.angle_rad, 0, 2 * place.pitch_nm},
              {place.angle_rad + kRightAngle, 0, 2 * place.pitch_nm}};
    case FillPattern::kTriangles:
      return ThreeWays(place, {0, 0, 0});
    case FillPattern::kStars:
      return ThreeWays(place, {0, 0, 1.5 * place.pitch_nm});
    case FillPattern::kCubic: {
      const double shift = static_cast<double>(place.z_nm) / std::numbers::sqrt2;
      return ThreeWays(place, {shift, shift, shift});
    }
    case FillPattern::kQuarterCubic:
      return QuarterCubicFamilies(place);
    default:
      return {};
  }
}

}  // namespace slicefarm::infill
