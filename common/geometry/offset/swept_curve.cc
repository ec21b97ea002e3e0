#include "common/geometry/offset/swept_curve.h"

#include <algorithm>
#include <cmath>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/geometry/predicates.h"
#include "common/geometry/vector.h"

namespace slicefarm::internal {
namespace {

/// 1 + cos of the turn at which a miter is twice as long as the distance; this is a corner of 60
/// degrees.
constexpr double kSharpest = 0.5;
/// Miters that extend less than this beyond their arc stay.
constexpr double kLeastExcessNm = 1'000;

struct Step {
  Point from;
  Vector2 direction;
  double length;
};

std::vector<Step> StepsOf(const Polygon& ring) {
  std::vector<Step> steps;
  steps.reserve(ring.size());
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], d = ring[i + 1 == ring.size() ? 0 : i + 1] - from;
    const double length = Norm(d);
    if (length == 0) continue;
    steps.push_back(
        {from, {static_cast<double>(d.x) / length, static_cast<double>(d.y) / length}, length});
  }
  return steps;
}

bool HasReflexCorner(const Polygon& ring) {
  for (size_t i = 0; i < ring.size(); ++i) {
    const Point before = ring[i == 0 ? ring.size() - 1 : i - 1];
    const Point after = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (Orientation(before, ring[i], after) < 0) return true;
  }
  return false;
}

class Sweeper {
 public:
  Sweeper(const Polygon& ring, double distance, std::optional<double> arc_tolerance)
      : steps_(StepsOf(ring)), distance_(distance), round_(arc_tolerance.has_value()) {
    // In a ring without reflex corners, a point may be in all rectangles and all overlaps. The
    // subtractions would then cancel out, so the first overlap remains.
    overlaps_left_out_ = HasReflexCorner(ring);
    if (round_) arc_step_ = 2 * Acos(1 - std::min(1.0, *arc_tolerance / distance));
  }

  SweptCurve Sweep() {
    curve_.edges = static_cast<int32_t>(steps_.size());
    curve_.points.reserve(2 * steps_.size());
    curve_.parts.reserve(2 * steps_.size());
    for (int32_t i = 0; i < curve_.edges; ++i)
      if (!Corner(i == 0 ? curve_.edges - 1 : i - 1, i)) return {};
    while (curve_.points.size() > 1 && curve_.points.back() == curve_.points.front()) {
      curve_.points.pop_back();
      curve_.parts.pop_back();
    }
    return std::move(curve_);
  }

 private:
  /// Appends a point; the curve's edge after it belongs to `part`.
  void Append(Point base, const Vector2& v, int32_t part) {
    const Point p{base.x + std::llround(v.x()), base.y + std::llround(v.y())};
    if (!curve_.points.empty() && curve_.points.back() == p) {
      curve_.parts.back() = part;
      return;
    }
    curve_.points.push_back(p);
    curve_.parts.push_back(part);
  }

  /// Appends the curve between edges i and j. Returns false if the ring reverses its direction.
  bool Corner(int32_t i, int32_t j) {
    const Step &e = steps_[i], &f = steps_[j];
    const Vector2 to_e = distance_ * TurnedLeft(e.direction),
                  to_f = distance_ * TurnedLeft(f.direction);
    const double cosine = Dot(e.direction, f.direction), straightness = 1 + cosine;
    if (straightness < 1e-9) return false;
    const bool convex = Cross(e.direction, f.direction) > 0;
    // Length of the overlap of the two rectangles along either edge, if the edges are long enough.
    const double reach = distance_ * std::abs(Cross(e.direction, f.direction));
    if (convex && (!overlaps_left_out_ || cosine < 0 || reach > e.length || reach > f.length)) {
      overlaps_left_out_ = true;
      Append(f.from, to_e, 2 * i + 1);
      Append(f.from, Vector2::Zero(), 2 * i + 1);
      Append(f.from, to_f, 2 * j);
    } else if (!convex && round_ && IsRounded(straightness)) {
      AppendArc(f.from, to_e, Acos(std::clamp(cosine, -1.0, 1.0)), 2 * i + 1);
      Append(f.from, to_f, 2 * j);
    } else if (!convex && straightness < kSharpest) {
      const double cut = distance_ * Tan(Acos(std::max(-1.0, cosine)) / 4);
      Append(f.from, to_e + cut * e.direction, 2 * i + 1);
      Append(f.from, to_f - cut * f.direction, 2 * j);
    } else {
      Append(f.from, 1 / straightness * (to_e + to_f), 2 * j);
    }
    return true;
  }

  /// Returns true if a miter extends much beyond its arc; its length is distance / cos(turn / 2).
  bool IsRounded(double straightness) const {
    return distance_ * (std::sqrt(2 / straightness) - 1) >= kLeastExcessNm;
  }

  /// Appends the points of the arc that starts at `from` and turns right, without its end.
  void AppendArc(Point at, const Vector2& from, double turn, int32_t part) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(turn / arc_step_)));
    for (int k = 0; k < pieces; ++k) {
      const double angle = turn * k / pieces, c = Cos(angle), s = Sin(angle);
      Append(at, c * from - s * TurnedLeft(from), part);
    }
  }

  const std::vector<Step> steps_;
  const double distance_;
  const bool round_;
  double arc_step_ = 0;  ///< angle of a chord
  bool overlaps_left_out_ = false;
  SweptCurve curve_;
};

}  // namespace

SweptCurve SweepInwards(const Polygon& ring, double distance_nm,
                        std::optional<double> arc_tolerance_nm) {
  return Sweeper(ring, distance_nm, arc_tolerance_nm).Sweep();
}

}  // namespace slicefarm::internal
