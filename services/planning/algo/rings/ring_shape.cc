#include "services/planning/algo/rings/ring_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/base/portable_math.h"

namespace slicefarm::planning {
namespace {

/// Largest arm of a short ring, as a share of its length.
constexpr double kArmOfLength = 1.0 / 8;
/// Smallest turn that counts as a corner.
constexpr double kLeastTurnRad = std::numbers::pi / 15;
/// Difference up to which turns of a rounded corner count as equal.
constexpr double kSameTurnRad = std::numbers::pi / 90;
/// Largest length of a corner, as a share of its ring.
constexpr double kLongestCorner = 1.0 / 3;

/// Tangent of 22.5 degrees.
constexpr double kSixteenth = std::numbers::sqrt2 - 1;
/// Square of the cosine of kLeastTurnRad.
constexpr double kStraightCosine2 = 0.95677;

/// Returns true if the bend turns by less than kLeastTurnRad, without computing the angle.
bool IsStraight(const Bend& bend) {
  const double cosine = Dot(bend.in, bend.out);
  return cosine > 0 &&
         cosine * cosine > kStraightCosine2 * SquaredNorm(bend.in) * SquaredNorm(bend.out);
}

}  // namespace

double Bend::TurnRad() const { return Atan2(Cross(in, out), Dot(in, out)); }

int Bend::Outward() const {
  const Point along = in + out;  // the solid is to the left of the ring
  auto x = static_cast<double>(along.y), y = static_cast<double>(-along.x);
  if (x == 0 && y == 0) return 0;
  int quarter = 0;
  // Turns the vector back by 90 degrees.
  for (; x <= 0 || y < 0; ++quarter) x = std::exchange(y, -x);
  return 4 * quarter + (y >= kSixteenth * x) + (y >= x) + (kSixteenth * y >= x);
}

double OutwardAngleRad(int outward) { return (outward + 0.5) * 2 * std::numbers::pi / kOutwards; }

RingShape::RingShape(const Polygon& ring, double arm_nm) : ring_(&ring) {
  ends_.reserve(ring.size() + 1);
  ends_.push_back(0);
  for (size_t i = 0; i < ring.size(); ++i)
    ends_.push_back(ends_.back() + Distance(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]));
  length_nm_ = ends_.back();
  arm_nm_ = std::min(arm_nm, length_nm_ * kArmOfLength);
}

Point RingShape::At(double along_nm, size_t& edge) const {
  if (along_nm < 0) along_nm += length_nm_;
  if (along_nm >= length_nm_) along_nm -= length_nm_;
  if (along_nm < ends_[edge]) edge = 0;
  while (edge + 1 < ring_->size() && along_nm >= ends_[edge + 1]) ++edge;
  const Point from = (*ring_)[edge], to = (*ring_)[edge + 1 < ring_->size() ? edge + 1 : 0];
  const double length = ends_[edge + 1] - ends_[edge];
  if (length <= 0) return from;
  const double share = std::clamp((along_nm - ends_[edge]) / length, 0.0, 1.0);
  // Coordinates are truncated to whole nanometres. This is exact enough, because seams later move
  // to the nearest point of a wall.
  return {from.x + static_cast<Coord>(share * static_cast<double>(to.x - from.x)),
          from.y + static_cast<Coord>(share * static_cast<double>(to.y - from.y))};
}

std::vector<Bend> RingShape::BendsAt(std::span<const double> along_nm) const {
  std::vector<Bend> bends;
  bends.reserve(along_nm.size());
  size_t before = 0, here = 0, after = 0;  // edge indices
  for (const double nm : along_nm) {
    const Point at = At(nm, here);
    bends.push_back({at, at - At(nm - arm_nm_, before), At(nm + arm_nm_, after) - at});
  }
  return bends;
}

std::vector<Corner> RingShape::Turns() const {
  const size_t n = ring_->size();
  std::vector<Corner> all;
  all.reserve(n);
  for (const Bend& bend : BendsAt(std::span(ends_).first(n)))
    all.push_back({ends_[all.size()], IsStraight(bend) ? 0 : bend.TurnRad()});
  // Starts at a straight place, so that no corner is split.
  const auto is_straight = [](const Corner& corner) {
    return std::abs(corner.turn_rad) < kLeastTurnRad;
  };
  const auto start = std::ranges::find_if(all, is_straight);
  for (auto corner = all.begin(); corner != start && start != all.end(); ++corner)
    corner->along_nm += length_nm_;
  if (start != all.end()) std::rotate(all.begin(), start, all.end());
  std::erase_if(all, is_straight);
  return all;
}

std::vector<Corner> RingShape::Corners() const {
  const std::vector<Corner> turns = Turns();
  const auto same_corner = [&](const Corner& a, const Corner& b) {
    return b.along_nm - a.along_nm <= arm_nm_ && (a.turn_rad > 0) == (b.turn_rad > 0);
  };
  std::vector<Corner> corners;
  for (size_t first = 0, last = 0; first < turns.size(); first = last) {
    last = first + 1;
    while (last < turns.size() && same_corner(turns[last - 1], turns[last])) ++last;
    double most = 0;
    for (size_t i = first; i < last; ++i) most = std::max(most, std::abs(turns[i].turn_rad));
    // Takes the middle of the points with the largest turn.
    std::vector<size_t> sharpest;
    for (size_t i = first; i < last; ++i)
      if (std::abs(turns[i].turn_rad) >= most - kSameTurnRad) sharpest.push_back(i);
    const double span = turns[sharpest.back()].along_nm - turns[sharpest.front()].along_nm;
    if (span > kLongestCorner * length_nm_) continue;
    Corner corner = turns[sharpest[sharpest.size() / 2]];
    if (corner.along_nm >= length_nm_) corner.along_nm -= length_nm_;
    corners.push_back(corner);
  }
  std::ranges::sort(corners, {}, &Corner::along_nm);
  return corners;
}

}  // namespace slicefarm::planning
