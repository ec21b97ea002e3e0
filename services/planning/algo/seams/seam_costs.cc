#include "services/planning/algo/seams/seam_costs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/base/split_mix.h"

namespace slicefarm::planning {
namespace {

constexpr double kOuterCorner = 0.5;
constexpr double kStraight = 3.5;
/// Smallest turn of a sharp corner.
constexpr double kSharpRad = std::numbers::pi / 4;
/// Cost of an invisible point, as a share of its cost in plain view. The difference is so small
/// that the corner counts more than the visibility.
constexpr double kHidden = 0.8;
constexpr double kSeen = 6;
/// Weight of corners with `hidden` and `rear`.
constexpr double kLittle = 0.25;
/// Cost per mm of distance in y from the rear-most place of the ring.
constexpr double kFromRear = 4;
/// Costs per mm that decide between nearly equal points. So seams of nested contours, and of
/// neighbouring holes, are close together, and the travel between them is short.
constexpr double kRearOfEqual = 2e-3;
constexpr double kLeftOfEqual = 1e-3;
/// Range of overhangs with one cost per layer height, from `from` (in layer heights) up to the next
/// range.
struct OverhangRange {
  double from = 0;
  double per_height = 0;  ///< cost per layer height in this range
};
/// Tangent of 55 degrees.
constexpr double kSteep = 1.43;
/// Cost ranges of overhangs. A slightly leaning wall does not justify a jump of the seam, but a
/// steep one does. Where a whole ring overhangs, the seam is best at the smallest overhang. A point
/// far in the air is hardly better than one still farther.
constexpr std::array<OverhangRange, 3> kOverhangs{{{0.6, 4}, {kSteep, 20}, {kSteep + 1, 5}}};
/// Costs that exceed all remaining costs of a job together.
constexpr double kBlocked = 1e9;
constexpr double kNotEnforced = 1e6;
/// Cost per mm between an enforced point and the middle of its section of the ring, and the maximum
/// of this cost. The maximum exceeds the cost of visibility, but not the advantage of a sharp
/// corner.
constexpr double kOffMiddle = 1;
constexpr double kMostOffMiddle = 2;

/// Returns the cost of the shape; 0 at a sharp inner corner.
double Shape(const SeamCandidate& candidate) {
  const double sharpness = std::min(std::abs(candidate.turn_rad) / kSharpRad, 1.0);
  const double corner = candidate.turn_rad < 0 ? 0 : kOuterCorner;
  return kStraight + (corner - kStraight) * sharpness;
}

double Overhang(const SeamCandidate& candidate) {
  double cost = 0, per_height = 0;
  for (const OverhangRange& range : kOverhangs) {
    cost += (range.per_height - per_height) * std::max(candidate.overhang - range.from, 0.0);
    per_height = range.per_height;
  }
  return cost;
}

/// Returns bits that depend evenly on all bits.
uint64_t Mixed(uint64_t bits) { return MixedBits(bits + kSplitMixStep); }

/// Returns a pseudo-random number in [0, 1).
double Random(RingNumber number, size_t candidate) {
  uint64_t bits = Mixed(static_cast<uint64_t>(number.object));
  bits = Mixed(bits ^ static_cast<uint64_t>(number.layer));
  bits = Mixed(bits ^ static_cast<uint64_t>(number.ring));
  bits = Mixed(bits ^ candidate);
  return ShareOfBits(bits);
}

Point RearMost(const std::vector<SeamCandidate>& candidates) {
  const auto candidate = std::ranges::min_element(
      candidates, {}, [](const SeamCandidate& p) { return std::pair(-p.at.y, p.at.x); });
  return candidate->at;
}

}  // namespace

std::vector<double> SeamCosts(const std::vector<SeamCandidate>& candidates,
                              const std::vector<double>& seen, SeamPosition position,
                              RingNumber number) {
  const Point rear = RearMost(candidates);
  const bool enforced = std::ranges::any_of(candidates, &SeamCandidate::enforced);
  std::vector<double> costs;
  for (size_t i = 0; i < candidates.size(); ++i) {
    const SeamCandidate& candidate = candidates[i];
    const double from_rear_mm = ToMm(static_cast<double>(rear.y - candidate.at.y));
    double cost = Overhang(candidate) + kRearOfEqual * from_rear_mm +
                  kLeftOfEqual * ToMm(static_cast<double>(candidate.at.x));
    switch (position) {
      case SeamPosition::kRear:
        cost += kFromRear * from_rear_mm + kLittle * Shape(candidate);
        break;
      case SeamPosition::kHidden:
        cost += kSeen * seen[i] + kLittle * Shape(candidate);
        break;
      case SeamPosition::kRandom:
        cost = Overhang(candidate) + Random(number, i);
        break;
      default:
        cost += Shape(candidate) * (kHidden + (1 - kHidden) * seen[i]);
    }
    if (candidate.enforced && position != SeamPosition::kRandom)
      cost += std::min(kOffMiddle * candidate.off_middle_mm, kMostOffMiddle);
    if (candidate.blocked) cost += kBlocked;
    if (enforced && !candidate.enforced) cost += kNotEnforced;
    costs.push_back(cost);
  }
  return costs;
}

StepCost StepCostOf(SeamPosition position) {
  if (position == SeamPosition::kRandom) return {0, 0, 0, 0};
  return {};
}

bool Overhangs(const SeamCandidate& candidate) { return candidate.overhang > kSteep; }

}  // namespace slicefarm::planning
