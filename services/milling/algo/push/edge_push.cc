#include "services/milling/algo/push/edge_push.h"

#include <algorithm>
#include <cmath>

#include "services/milling/algo/push/bull_push.h"

namespace slicefarm::milling {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Square of half the chord that the cutter's section at the contact's height cuts out of the
/// fiber. It is c + b s + a s^2 if the cutter touches the edge at the position s. `growth`: sign of
/// the direction of s in which the square grows, if a >= 0.
struct HalfChord {
  double a = 0;
  double b = 0;
  double c = 0;
  double growth = 0;
  double discriminant = 0;  ///< b^2 - 4 a c, computed without cancellation
};

HalfChord HalfChordOf(const ProfilePiece& piece, const FiberPoint& from, const FiberPoint& step) {
  const double dh = step.height, dv = step.across, h = from.height, v = from.across;
  if (piece.corner_mm > 0) {
    const double r = piece.corner_mm, square = h * (2 * r - h);
    return {.a = -(dh * dh + dv * dv),
            .b = 2 * (dh * (r - h) - v * dv),
            .c = square - v * v,
            .discriminant =
                4 * (dv * dv * square + dh * (dh * (r - v) * (r + v) - 2 * v * (r - h) * dv))};
  }
  const double width = piece.base_mm + piece.slope * h, growth = piece.slope * dh;
  const double root = growth * v - width * dv;
  return {.a = (growth - dv) * (growth + dv),
          .b = 2 * (width * growth - v * dv),
          .c = (width - v) * (width + v),
          .growth = growth,
          .discriminant = 4 * root * root};
}

/// Returns the s for which `along` s + sqrt(Q(s)) is largest; not finite if it grows without end.
double LargestAt(const HalfChord& q, double along) {
  const double m = along * along - q.a;
  const double rate = m > 0 ? std::sqrt(std::max(0.0, q.discriminant) / m) : 0;
  const double t = -along * rate;  // dQ/ds at the maximum
  if (q.a >= 0) {
    const double pass = q.growth != 0 ? q.growth : along;
    if (m <= 0 || along * q.growth >= 0) return pass > 0 ? kEndless : -kEndless;
  }
  if (t * q.b > 0) return (q.b * q.b - 4 * along * along * q.c) / (2 * m * (t + q.b));
  return (t - q.b) / (2 * q.a);
}

/// Returns the square of the half chord; 0 or less if the cutter does not reach the fiber.
double HalfChordAt(const ProfilePiece& piece, const FiberPoint& p) {
  if (piece.corner_mm > 0) return p.height * (2 * piece.corner_mm - p.height) - p.across * p.across;
  const double width = piece.base_mm + piece.slope * p.height;
  return (width - p.across) * (width + p.across);
}

FiberPoint On(const FiberPoint& from, const FiberPoint& step, double s) {
  return {from.along + s * step.along, from.across + s * step.across,
          from.height + s * step.height};
}

/// Part of an edge in the height range of one piece of the outline: s in [0, length].
struct EdgePart {
  FiberPoint from;
  FiberPoint step;
  double start = 0;  ///< s of the part's start on the whole edge
  double length = 0;
};

/// Position s of the interval's end on a part, and the square of the half chord at this position.
struct SideContact {
  double s = 0;
  double along = 0;
  double square = 0;
};

/// Extends the reach by a part of the edge. If the half chord is 0 at one end of the interval only,
/// the cutter touches there with its tip.
void Unite(const EdgePart& part, const SideContact& high, const SideContact& low, Reach& reach) {
  if (!(std::max(high.square, low.square) > 0)) return;
  const double high_end = high.along + std::sqrt(std::max(0.0, high.square)),
               low_end = low.along - std::sqrt(std::max(0.0, low.square));
  if (high_end > reach.high) reach.high = high_end, reach.high_at = part.start + high.s;
  if (low_end < reach.low) reach.low = low_end, reach.low_at = part.start + low.s;
}

void PushQuadratic(const ProfilePiece& piece, const EdgePart& part, Reach& reach) {
  const HalfChord q = HalfChordOf(piece, part.from, part.step);
  if (q.a < 0 && q.discriminant <= 0) return;
  const auto contact = [&](double side) {
    const double best = LargestAt(q, side * part.step.along);
    const double s = best > 0 ? std::min(best, part.length) : 0;  // 0 for NaN too
    const FiberPoint p = On(part.from, part.step, s);
    return SideContact{s, p.along, HalfChordAt(piece, p)};
  };
  Unite(part, contact(1), contact(-1), reach);
}

void PushBull(const ProfilePiece& piece, const EdgePart& part, Reach& reach) {
  const auto contact = [&](double side) {
    const double s = BullContact(piece, part.from, part.step, part.length, side);
    const FiberPoint p = On(part.from, part.step, s);
    const double width =
        piece.flat_mm + std::sqrt(std::max(0.0, p.height * (2 * piece.corner_mm - p.height)));
    return SideContact{s, p.along, (width - p.across) * (width + p.across)};
  };
  Unite(part, contact(1), contact(-1), reach);
}

/// Sets `part` to the part of the edge in the height range of the piece. Returns false if there is
/// none.
bool PartOf(const ProfilePiece& piece, const FiberPoint& a, const FiberPoint& step, double top,
            EdgePart& part) {
  double s0 = 0, s1 = 1;
  if (step.height > 0) {
    if (a.height < piece.from_mm) s0 = (piece.from_mm - a.height) / step.height;
    if (top > piece.to_mm) s1 = (piece.to_mm - a.height) / step.height;
  } else if (step.height < 0) {
    if (a.height > piece.to_mm) s0 = (piece.to_mm - a.height) / step.height;
    if (a.height + step.height < piece.from_mm) s1 = (piece.from_mm - a.height) / step.height;
  }
  if (!(s0 <= s1)) return false;
  part = {.from = On(a, step, s0), .step = step, .start = s0, .length = s1 - s0};
  // The clamp prevents rounding from leaving the arc or the cone.
  part.from.height = std::clamp(part.from.height, piece.from_mm, piece.to_mm);
  return true;
}

}  // namespace

Reach PushEdge(const Cutter& cutter, const FiberPoint& a, const FiberPoint& b) {
  const FiberPoint step{b.along - a.along, b.across - a.across, b.height - a.height};
  const double bottom = std::min(a.height, b.height), top = std::max(a.height, b.height);
  Reach reach;
  for (const ProfilePiece& piece : cutter.pieces()) {
    EdgePart part;
    if (top < piece.from_mm || bottom > piece.to_mm) continue;
    if (!PartOf(piece, a, step, top, part)) continue;
    if (piece.corner_mm > 0 && piece.flat_mm > 0)
      PushBull(piece, part, reach);
    else
      PushQuadratic(piece, part, reach);
  }
  return reach;
}

}  // namespace slicefarm::milling
