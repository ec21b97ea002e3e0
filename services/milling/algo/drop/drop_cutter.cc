#include "services/milling/algo/drop/drop_cutter.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace slicefarm::milling {
namespace {

constexpr int kMostSteps = 100;
constexpr double kRootShare = 1e-10;
constexpr double kOnSideMm = 1e-9;

/// Highest position found so far at which the lowered cutter touches something. The cutter's axis
/// is at the origin.
struct Rest {
  double z = -std::numeric_limits<double>::infinity();
  Eigen::Vector3d contact{0, 0, 0};
};

/// Tests one contact point. `distance`: distance of p from the axis. A point on the rim is tested
/// with exactly the rim's distance, because rounding could move p beyond the rim.
void Touch(const Cutter& cutter, const Eigen::Vector3d& p, double distance, Rest& rest) {
  if (distance > cutter.radius_mm() * (1 + 1e-15)) return;
  const double z = p.z() - cutter.HeightAt(std::min(distance, cutter.radius_mm()));
  if (z > rest.z) rest = {z, p};
}

/// Returns the root of a decreasing function between 0 and `high`, with an error of at most
/// kRootShare of `high`. The method is false position with the Illinois rule, and bisection where
/// false position is slow. The height of a contact is wrong by only the square of this error.
template <typename Falling>
double RootOfFalling(const Falling& value_at, double high) {
  double low = 0, at_low = value_at(low), at_high = value_at(high), x = high;
  const double enough = kRootShare * high;
  for (int i = 0; i < kMostSteps && high - low > enough; ++i) {
    const double secant = high + (high - low) * at_high / (at_low - at_high);
    x = i % 4 < 3 && secant > low && secant < high ? secant : (low + high) / 2;
    const double at_x = value_at(x);
    if (at_x > 0) {
      low = x, at_low = at_x, at_high /= 2;
    } else {
      high = x, at_high = at_x, at_low /= 2;
    }
  }
  return x;
}

/// Returns the position at which an edge touches a piece of the outline, on the side to which the
/// edge rises. The position is a length in mm along the edge, seen from above, from the point
/// nearest to the cutter's axis. `off`: distance of the edge from the axis; `rise`: slope of the
/// edge. If there is no contact, the result is not finite, or outside of the piece.
double TouchAlong(const ProfilePiece& piece, double off, double rise) {
  if (piece.corner_mm <= 0) {  // the outline rises by 1 / slope
    const double cosine = rise * piece.slope;
    return off * cosine / std::sqrt(1 - cosine * cosine);
  }
  const double reach = piece.corner_mm + piece.flat_mm;
  const double most = std::sqrt(std::max(0.0, reach * reach - off * off));
  if (piece.flat_mm == 0) return most * rise / std::sqrt(1 + rise * rise);
  // Returns the difference between the slopes of the edge and of the outline, times a positive
  // factor. It decreases from 0 to `most`. The outline's slope along the edge is out / up * x /
  // distance.
  const auto steeper = [&](double x) {
    const double distance = std::sqrt(off * off + x * x);
    const double out = std::max(0.0, distance - piece.flat_mm);
    const double up = std::sqrt(std::max(0.0, piece.corner_mm * piece.corner_mm - out * out));
    return rise * up - (distance > 0 ? out * x / distance : 0);
  };
  return RootOfFalling(steeper, most);
}

/// Tests a side of a triangle: its contacts with the kinks, pieces and rim of the cutter's outline.
void TouchEdge(const Cutter& cutter, Eigen::Vector3d a, Eigen::Vector3d b, Rest& rest) {
  Touch(cutter, a, a.head<2>().norm(), rest);
  Touch(cutter, b, b.head<2>().norm(), rest);
  if (a.z() > b.z()) std::swap(a, b);
  const double length = (b - a).head<2>().norm();
  if (!(length > 0)) return;
  const Eigen::Vector2d pass = (b - a).head<2>() / length;
  const double foot = -a.head<2>().dot(pass), rise = (b.z() - a.z()) / length;
  const double off = std::abs(a.x() * pass.y() - a.y() * pass.x());
  if (!(off < cutter.radius_mm())) return;
  // Upper limit for the height of all contacts: the highest point of the side under the cutter,
  // minus the lowest height of the outline above the side.
  const double half = std::sqrt((cutter.radius_mm() - off) * (cutter.radius_mm() + off));
  const double most = a.z() + rise * std::min(length, std::max(0.0, foot + half));
  if (most - cutter.HeightAt(off) <= rest.z) return;
  const auto touch_at = [&](double x) {
    const double along = foot + x;
    if (along > 0 && along < length)
      Touch(cutter, a + (b - a) * (along / length), std::sqrt(off * off + x * x), rest);
  };
  touch_at(0);
  for (const ProfilePiece& piece : cutter.pieces()) {
    const double rim = cutter.Width(piece.from_mm);
    if (rim > off) touch_at(std::sqrt((rim - off) * (rim + off)));
    if (piece.corner_mm > 0 || piece.slope > 0) touch_at(TouchAlong(piece, off, rise));
  }
}

/// Tests the inside of a triangle: the point at which the triangle's slope touches the outline.
/// Seen from the axis, this point is uphill.
void TouchFacet(const Cutter& cutter, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                const Eigen::Vector3d& c, Rest& rest) {
  Eigen::Vector3d normal = (b - a).cross(c - a);
  if (normal.z() == 0) return;
  if (normal.z() < 0) normal = -normal;
  normal.normalize();
  const double flat = normal.head<2>().norm();
  Eigen::Vector2d at(0, 0);
  double width = 0;
  if (flat > 0) {
    width = cutter.Width(cutter.TouchHeight(flat, normal.z()));
    at = -width / flat * normal.head<2>();
  }
  // The value is positive if the point is on the inner side of this side; the triangle is
  // counter-clockwise. Points on a side count: a slope that ends on the rim is under the cutter up
  // to its end.
  const double turn = (b - a).head<2>().dot(Eigen::Vector2d(c.y() - a.y(), a.x() - c.x()));
  const auto outside = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    const double x = q.x() - p.x(), y = q.y() - p.y();
    const double left = x * (at.y() - p.y()) - y * (at.x() - p.x());
    return (turn > 0 ? left : -left) < -kOnSideMm * (std::abs(x) + std::abs(y));
  };
  if (outside(a, b) || outside(b, c) || outside(c, a)) return;
  const double z =
      a.z() - (normal.x() * (at.x() - a.x()) + normal.y() * (at.y() - a.y())) / normal.z();
  Touch(cutter, {at.x(), at.y(), std::min(z, std::max({a.z(), b.z(), c.z()}))}, width, rest);
}

}  // namespace

std::optional<Drop> DropCutter::At(const Eigen::Vector2d& place_mm) const {
  const Eigen::Vector2d reach(cutter_.radius_mm(), cutter_.radius_mm());
  const Eigen::Vector3d axis(place_mm.x(), place_mm.y(), 0);
  Rest rest;
  triangles_.ForEachIn(place_mm - reach, place_mm + reach, [&](uint32_t t) {
    const auto& corners = mesh_.triangles[t];
    const Eigen::Vector3d a = mesh_.points_mm[corners[0]] - axis,
                          b = mesh_.points_mm[corners[1]] - axis,
                          c = mesh_.points_mm[corners[2]] - axis;
    if (std::max({a.z(), b.z(), c.z()}) <= rest.z) return;
    TouchEdge(cutter_, a, b, rest);
    TouchEdge(cutter_, b, c, rest);
    TouchEdge(cutter_, c, a, rest);
    TouchFacet(cutter_, a, b, c, rest);
  });
  if (!std::isfinite(rest.z)) return std::nullopt;
  return Drop{rest.z, rest.contact + axis};
}

}  // namespace slicefarm::milling
