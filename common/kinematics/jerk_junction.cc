#include "common/kinematics/jerk_junction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slicefarm {
namespace {

constexpr double kCos45 = 0.70710678118654752;

/// Returns the cube root, by Newton's steps from above. REQUIRES: x > 0.
double CubeRoot(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  double root = std::ldexp(1.0, exponent / 3 + 1);
  for (;;) {
    const double next = (2 * root + x / (root * root)) / 3;
    if (next >= root) return root;
    root = next;
  }
}

}  // namespace

Bend BendBetween(const KinematicMove& before, const KinematicMove& move, double deviation_mm) {
  if (before.ExtruderOnly() || move.ExtruderOnly()) return {.sharp = true, .stop = true};
  const double turn_cos = before.ratio[kX] * move.ratio[kX] + before.ratio[kY] * move.ratio[kY] +
                          before.ratio[kZ] * move.ratio[kZ];
  const double sin_half = std::sqrt(std::max(0.0, (1 - turn_cos) / 2));
  const double cos_half = std::sqrt(std::max(0.0, (1 + turn_cos) / 2));
  Bend bend;
  bend.curvature = 4 * sin_half / (before.length_mm + move.length_mm);
  if (cos_half == 0) return {.sharp = true, .stop = true};
  // An arc of radius r passes the corner at a distance of r (1 / cos_half - 1).
  bend.corner = (1 - cos_half) / (cos_half * deviation_mm);
  bend.sharp = turn_cos < kCos45;
  return bend;
}

double SpeedThrough(const Bend& bend, double change, const RampLimits& limits) {
  if (bend.stop) return 0;
  const double k = std::max(bend.curvature, bend.corner);
  const double squares = change * change + k * k * k * k;
  double v = std::numeric_limits<double>::infinity();
  if (k > 0) v = std::sqrt(limits.acceleration_mm_s2 / k);
  if (squares > 0) {
    const double v3 = limits.jerk_mm_s3 / std::sqrt(squares);
    if (v * v * v > v3) v = CubeRoot(v3);
  }
  return v;
}

}  // namespace slicefarm
