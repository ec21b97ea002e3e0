#include "services/infill/algo/patterns/line_families.h"

#include <array>
#include <numbers>

namespace slicefarm::infill {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kThirdTurn = 2 * std::numbers::pi / 3;

/// Returns three directions that sum to zero. `shift_nm`: distance of each family from the origin,
/// to the left of its direction.
std::vector<LineFamily> ThreeWays(const PatternPlace& place, const std::array<double, 3>& shift_nm) {
  std::vector<LineFamily> families;
  for (size_t i = 0; i < 3; ++i)
    families.push_back({place.angle_rad + static_cast<double>(i) * kThirdTurn, shift_nm[i],
                        3 * place.pitch_nm});
  return families;
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
    default:
      return {};
  }
}

}  // namespace slicefarm::infill
