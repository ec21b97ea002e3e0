#include "common/geometry/offset/offset_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/geometry/vector.h"

namespace slicefarm::internal {
namespace {

Polygon WithoutRepeats(const Polygon& ring) {
  Polygon points;
  points.reserve(ring.size());
  for (const Point p : ring)
    if (points.empty() || points.back() != p) points.push_back(p);
  while (points.size() > 1 && points.back() == points.front()) points.pop_back();
  return points;
}

Vector2 RightOf(Point from, Point to) {
  const auto dx = static_cast<double>(to.x - from.x), dy = static_cast<double>(to.y - from.y);
  const double scale = 1 / std::sqrt(dx * dx + dy * dy);
  return {dy * scale, -(dx * scale)};
}

/// Returns the value rounded half away from zero.
Coord Rounded(double value) { return static_cast<Coord>(value < 0 ? value - 0.5 : value + 0.5); }

class CurveMaker {
 public:
  CurveMaker(const Polygon& ring, double distance, const OffsetOptions& options)
      : points_(WithoutRepeats(ring)), distance_(distance), options_(options) {}

  Polygon Make() {
    const size_t count = points_.size();
    if (count < 3) return {};
    if (options_.join == Join::kRound) PrepareArcs();
    for (size_t i = 0; i < count; ++i)
      normals_.push_back(RightOf(points_[i], points_[i + 1 == count ? 0 : i + 1]));
    curve_.reserve(2 * count);
    size_t before = count - 1;
    for (size_t i = 0; i < count; ++i)
      if (Corner(points_[i], normals_[before], normals_[i])) before = i;
    return std::move(curve_);
  }

 private:
  void PrepareArcs() {
    const double radius = std::abs(distance_);
    const auto wanted = static_cast<double>(options_.arc_tolerance_nm);
    const double tolerance = wanted <= 0 ? 0.25 : std::min(wanted, radius * 0.25);
    const double steps =
        std::min(std::numbers::pi / Acos(1 - tolerance / radius), radius * std::numbers::pi);
    constexpr double kTurn = 2 * std::numbers::pi;
    step_sine_ = std::copysign(Sin(kTurn / steps), distance_);
    step_cosine_ = Cos(kTurn / steps);
    steps_per_rad_ = steps / kTurn;
  }

  void Append(Point at, double x, double y) {
    curve_.push_back(
        {Rounded(static_cast<double>(at.x) + x), Rounded(static_cast<double>(at.y) + y)});
  }
  void Append(Point at, Vector2 n) { Append(at, n.x() * distance_, n.y() * distance_); }

  /// Appends the join of edges `in` and `out` at a corner. Returns false if the edges are nearly
  /// straight: then the next corner is also measured against `in`, so that many small turns add up.
  bool Corner(Point at, Vector2 in, Vector2 out) {
    double sine = Cross(in, out);
    const double cosine = Dot(in, out);
    if (std::abs(sine * distance_) < 1) {
      if (cosine > 0) {
        Append(at, in);
        return false;
      }
    } else {
      sine = std::clamp(sine, -1.0, 1.0);
    }
    if (sine * distance_ < 0) {
      Append(at, in);
      curve_.push_back(at);
      Append(at, out);
    } else {
      JoinEdges(at, in, out, sine, cosine);
    }
    return true;
  }

  void JoinEdges(Point at, Vector2 in, Vector2 out, double sine, double cosine) {
    const double limit = options_.miter_limit;
    const double least = limit > 2 ? 2 / (limit * limit) : 0.5;
    if (options_.join == Join::kRound) {
      AppendArc(at, in, out, Atan2(sine, cosine));
    } else if (options_.join == Join::kMiter && 1 + cosine >= least) {
      const double reach = distance_ / (1 + cosine);
      Append(at, (in.x() + out.x()) * reach, (in.y() + out.y()) * reach);
    } else {
      const double cut = Tan(Atan2(sine, cosine) / 4);
      Append(at, distance_ * (in.x() - in.y() * cut), distance_ * (in.y() + in.x() * cut));
      Append(at, distance_ * (out.x() + out.y() * cut), distance_ * (out.y() - out.x() * cut));
    }
  }

  void AppendArc(Point at, Vector2 from, Vector2 to, double turn) {
    const auto steps = std::max<Coord>(Rounded(steps_per_rad_ * std::abs(turn)), 1);
    Vector2 n = from;
    for (Coord i = 0; i < steps; ++i) {
      Append(at, n);
      n = {n.x() * step_cosine_ - step_sine_ * n.y(), n.x() * step_sine_ + n.y() * step_cosine_};
    }
    Append(at, to);
  }

  const Polygon points_;
  const double distance_;
  const OffsetOptions& options_;
  std::vector<Vector2> normals_;
  Polygon curve_;
  double step_sine_ = 0, step_cosine_ = 1, steps_per_rad_ = 0;
};

}  // namespace

Polygon OffsetCurve(const Polygon& ring, double distance_nm, const OffsetOptions& options) {
  return CurveMaker(ring, distance_nm, options).Make();
}

}  // namespace slicefarm::internal
