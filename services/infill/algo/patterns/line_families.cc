#include "services/infill/algo/patterns/line_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "common/base/portable_math.h"

namespace slicefarm::infill {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kThirdTurn = 2 * std::numbers::pi / 3;

/// Returns three directions that sum to zero. `shift_nm`: distance of each family from the origin,
/// to the left of its direction.
std::vector<LineFamily> ThreeWays(const PatternContext& context,
                                  const std::array<double, 3>& shift_nm) {
  std::vector<LineFamily> families;
  for (size_t i = 0; i < 3; ++i)
    families.push_back({context.angle_rad + static_cast<double>(i) * kThirdTurn, shift_nm[i],
                        3 * context.pitch_nm});
  return families;
}

/// Returns the distance of each family of a pair from the middle between both, at a height. It
/// rises and falls by height / sqrt 2. The lines of both families stay a spacing apart.
double PairShift(const PatternContext& context, double height_nm, double apart_nm) {
  const double turns = height_nm / std::numbers::sqrt2 / apart_nm;
  const double phase = turns - std::floor(turns);
  const double half = static_cast<double>(context.spacing_nm) / 2;
  const double shift = std::min(phase, 1 - phase) * apart_nm;
  return std::max(half, std::min(shift, apart_nm / 2 - half));
}

/// Returns the sections of four families of planes, inclined to all sides: two directions with a
/// pair of families each. The planes of one direction are a quarter of a period in z above the
/// planes of the other direction. So they enclose regular tetrahedra and tetrahedra with cut
/// corners.
std::vector<LineFamily> QuarterCubicFamilies(const PatternContext& context) {
  const double apart = 4 * context.pitch_nm;
  const auto z = static_cast<double>(context.z_nm);
  const double quarter = std::numbers::sqrt2 * apart / 4;
  const double first = PairShift(context, z, apart),
               second = PairShift(context, z + quarter, apart);
  return {{context.angle_rad, first, apart},
          {context.angle_rad, -first, apart},
          {context.angle_rad + kRightAngle, second, apart},
          {context.angle_rad + kRightAngle, -second, apart}};
}

/// Returns the angle of lines in direction `context.angle_rad`, or of these lines mirrored in the y
/// axis.
double MirroredAngle(const PatternContext& context) {
  return context.shape.mirrored ? -context.angle_rad : context.angle_rad;
}

/// Returns parallel lines that are shifted from their position two layers below, in even layers to
/// the right and in odd layers to the left.
std::vector<LineFamily> CrossZagFamilies(const PatternContext& context) {
  const auto steps = static_cast<double>(context.layer / 2);
  const double side = context.layer % 2 != 0 ? 1 : -1;
  return {{MirroredAngle(context), side * steps * static_cast<double>(context.shape.shift_nm),
           context.pitch_nm}};
}

/// Returns two families of parallel lines, `apart_nm` between lines of one family. Their distance
/// from each other is at least a spacing, so that no line lies on another. If there is no space for
/// this, lines of one family are in the middle between lines of the other.
std::vector<LineFamily> BesideEachOther(const PatternContext& context, double first_nm,
                                        double second_nm, double apart_nm) {
  const auto least = std::min(static_cast<double>(context.spacing_nm), apart_nm / 2);
  const double turns = (second_nm - first_nm) / apart_nm;
  const double between = (turns - std::floor(turns)) * apart_nm;
  const double kept = std::clamp(between, least, apart_nm - least);
  const double middle = first_nm + between / 2;
  const double angle = context.angle_rad + kRightAngle;
  return {{angle, middle - kept / 2, apart_nm}, {angle, middle + kept / 2, apart_nm}};
}

/// Returns the sections of two families of planes that are inclined by two angles against the
/// vertical.
std::vector<LineFamily> LateralLatticeFamilies(const PatternContext& context) {
  const auto z = static_cast<double>(context.z_nm);
  return BesideEachOther(context, z * Tan(context.shape.lattice_1_rad),
                         z * Tan(context.shape.lattice_2_rad), 2 * context.pitch_nm);
}

/// Returns the section of upright hexagons. Each third of a period in z is as high as a sloped wall
/// of a hexagon. Two thirds have upright walls. In one third each wall forks, and its branches join
/// the branches of the walls beside it half a period further.
std::vector<LineFamily> LateralHoneycombFamilies(const PatternContext& context) {
  const double half = 2 * context.pitch_nm / 3;
  const double third = half / Tan(context.shape.honeycomb_rad);
  const double height = static_cast<double>(context.z_nm) / third;
  const auto number = static_cast<int64_t>(std::floor(height));
  // The first fork begins two thirds above the bed.
  const bool forks = (number + 1) % 3 == 0;
  const double middle = ((number + 1) / 3) % 2 != 0 ? half : 0;
  if (!forks) return {{context.angle_rad + kRightAngle, middle, 2 * half}};
  const double aside = (1 - (height - static_cast<double>(number))) * half;
  return BesideEachOther(context, middle - aside, middle + aside, 2 * half);
}

/// Returns the families that form a pattern, with one line in place of several lines side by side.
std::vector<LineFamily> SingleFamilies(FillPattern pattern, const PatternContext& context) {
  switch (pattern) {
    case FillPattern::kAlignedRectilinear:
      return {{context.angle_rad, 0, context.pitch_nm}};
    case FillPattern::kZigzag:
      return {{MirroredAngle(context), 0, context.pitch_nm}};
    case FillPattern::kCrossZag:
    case FillPattern::kLockedZag:
      return CrossZagFamilies(context);
    case FillPattern::kLateralLattice:
      return LateralLatticeFamilies(context);
    case FillPattern::kLateralHoneycomb:
      return LateralHoneycombFamilies(context);
    case FillPattern::kRectilinear:
    case FillPattern::kLine:
    case FillPattern::kMonotonic:
    case FillPattern::kMonotonicLines:
      return {{context.layer % 2 != 0 ? context.angle_rad + kRightAngle : context.angle_rad, 0,
               context.pitch_nm}};
    case FillPattern::kGrid:
      return {{context.angle_rad, 0, 2 * context.pitch_nm},
              {context.angle_rad + kRightAngle, 0, 2 * context.pitch_nm}};
    case FillPattern::kTriangles:
      return ThreeWays(context, {0, 0, 0});
    case FillPattern::kStars:
      return ThreeWays(context, {0, 0, 1.5 * context.pitch_nm});
    case FillPattern::kCubic: {
      const double shift = static_cast<double>(context.z_nm) / std::numbers::sqrt2;
      return ThreeWays(context, {shift, shift, shift});
    }
    case FillPattern::kQuarterCubic:
      return QuarterCubicFamilies(context);
    default:
      return {};
  }
}

/// Returns `lines` families in place of each family, a spacing apart.
std::vector<LineFamily> SideBySide(std::span<const LineFamily> families, int32_t lines,
                                   Coord spacing_nm) {
  std::vector<LineFamily> all;
  for (const LineFamily& family : families)
    for (int32_t i = 0; i < lines; ++i) {
      LineFamily& line = all.emplace_back(family);
      line.phase_nm += (i - (lines - 1) / 2.0) * static_cast<double>(spacing_nm);
    }
  return all;
}

}  // namespace

std::vector<LineFamily> LineFamiliesOf(FillPattern pattern, const PatternContext& context) {
  const int32_t lines = context.shape.lines;
  if (lines == 1) return SingleFamilies(pattern, context);
  PatternContext wide = context;
  wide.pitch_nm *= lines;
  wide.spacing_nm *= lines;
  return SideBySide(SingleFamilies(pattern, wide), lines, context.spacing_nm);
}

}  // namespace slicefarm::infill
