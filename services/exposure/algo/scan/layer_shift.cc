#include "services/exposure/algo/scan/layer_shift.h"

#include <array>
#include <cmath>

#include "common/geometry/line_axes.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {
namespace {

/// Steps of low-discrepancy sequences: in one dimension the fraction of the golden ratio, in the
/// plane 1 / g and 1 / g^2 of the plastic number g = 1.3247...
constexpr double kGolden = 0.61803398874989485;
constexpr double kPlastic1 = 0.75487766624669276, kPlastic2 = 0.56984029099805327;
constexpr int32_t kRingTurns = 3;
/// Permutations of the possible values, in which consecutive layers never have consecutive values.
constexpr std::array<int32_t, kBorderTurns> kBorderTurn = {0, 3, 1, 4, 2, 5};
constexpr std::array<int32_t, kCornerTurns> kCornerTurn = {0, 2, 4, 1, 3};

double Turn(int32_t layer, double step) {
  const double at = layer * step;
  return at - std::floor(at);
}

/// Returns the period of the hatch grid in nm. Cells of two kinds alternate, so their grid repeats
/// after two cells.
double Period(const ExposureOptions& options) {
  switch (options.strategy) {
    case ScanStrategy::kStripes:
      return 2 * static_cast<double>(options.stripe_width_nm);
    case ScanStrategy::kIslands:
      return 2 * static_cast<double>(options.island_width_nm);
    default:
      return static_cast<double>(options.hatch_distance_nm);
  }
}

}  // namespace

Point GridShift(int32_t layer, double angle_deg, const ExposureOptions& options) {
  if (!options.shift_grids) return {};
  const double period = Period(options);
  return LineAxes::OfDegrees(angle_deg).At(Turn(layer, kPlastic1) * period,
                                           Turn(layer, kPlastic2) * period);
}

int32_t BorderLines(int32_t layer, const ExposureOptions& options) {
  const bool overlaps = options.contours > 0 && 2 * options.hatch_offset_nm <= options.spot_nm;
  if (!options.shift_grids || !overlaps || IsRings(options.strategy)) return 0;
  return kBorderTurn[static_cast<size_t>(layer % kBorderTurns)];
}

RingTurn RingTurnOf(int32_t layer) {
  return {kCornerTurn[static_cast<size_t>(layer % kCornerTurns)], Turn(layer, kPlastic1)};
}

double RingStart(int32_t layer) { return Turn(layer, kGolden); }

double ContourShare(int32_t layer, int32_t number) {
  const double share = Turn(layer, kGolden) + Turn(number, kPlastic1);
  return share - std::floor(share);
}

int32_t CutVariant(int32_t layer, const ExposureOptions& options) {
  return options.turn_rings ? layer % kRingTurns : 0;
}

}  // namespace slicefarm::exposure
