#include "services/texture/algo/map/frame.h"

#include <algorithm>
#include <cmath>

#include "services/texture/algo/map/exact_turn.h"

namespace slicefarm::texture {
namespace {

bool BoxesMeet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
               const Eigen::Vector2d& d) {
  return (a.cwiseMin(b).array() <= c.cwiseMax(d).array()).all() &&
         (c.cwiseMin(d).array() <= a.cwiseMax(b).array()).all();
}

double Gap(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return (p - a).norm() + (p - b).norm() - (b - a).norm();
}

/// Calls `take(pair, gap)` for each pair of an edge and a point closer than `reach`.
template <class Take>
void ForNearPairs(std::span<const Eigen::Vector2d> frame, double reach, const Take& take) {
  const auto n = static_cast<int32_t>(frame.size());
  for (int32_t a = 0; a < n; ++a) {
    const int32_t b = (a + 1) % n;
    const Eigen::Vector2d low = frame[a].cwiseMin(frame[b]).array() - reach;
    const Eigen::Vector2d high = frame[a].cwiseMax(frame[b]).array() + reach;
    for (int32_t p = 0; p < n; ++p) {
      if (p == a || p == b) continue;
      if ((frame[p].array() < low.array()).any() || (frame[p].array() > high.array()).any())
        continue;
      const double gap = Gap(frame[a], frame[b], frame[p]);
      if (gap < reach) take(FrameBarrier::Pair{a, b, p}, gap);
    }
  }
}

/// Returns the gradient of the gap with respect to the coordinates of a, b and the point.
Eigen::Matrix<double, 6, 1> GapGradient(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                        const Eigen::Vector2d& p) {
  const Eigen::Vector2d from_a = (p - a).normalized(), from_b = (p - b).normalized();
  const Eigen::Vector2d along = (b - a).normalized();
  Eigen::Matrix<double, 6, 1> gradient;
  gradient << -from_a + along, -from_b - along, from_a + from_b;
  return gradient;
}

}  // namespace

FrameBarrier::FrameBarrier(std::span<const Eigen::Vector2d> frame) {
  double length = 0;
  for (size_t i = 0; i < frame.size(); ++i)
    length += (frame[(i + 1) % frame.size()] - frame[i]).norm();
  reach_ = length / static_cast<double>(frame.size()) / 4;
}

double FrameBarrier::Energy(std::span<const Eigen::Vector2d> frame) const {
  double energy = 0;
  ForNearPairs(frame, reach_, [&](const Pair&, double gap) {
    const double over = 1 - reach_ / gap;
    energy += over * over;
  });
  return energy;
}

std::vector<FrameBarrier::Term> FrameBarrier::Terms(std::span<const Eigen::Vector2d> frame) const {
  std::vector<Term> terms;
  ForNearPairs(frame, reach_, [&](const Pair& pair, double gap) {
    const Eigen::Vector2d &a = frame[pair.a], &b = frame[pair.b];
    const Eigen::Matrix<double, 6, 1> by_corner = GapGradient(a, b, frame[pair.point]);
    const double ratio = reach_ / gap;
    const double slope = 2 * (1 - ratio) * ratio / gap;
    const double curve = (6 * ratio * ratio - 4 * ratio) / (gap * gap);
    Term& term = terms.emplace_back();
    term.pair = pair;
    term.model.gradient = slope * by_corner;
    term.model.hessian = curve * by_corner * by_corner.transpose();
    // The Hessian of the gap is multiplied by a negative derivative. So only its part from -|ab|
    // becomes positive; the other parts are left out.
    const Eigen::Vector2d edge = b - a;
    const Eigen::Vector2d across = Eigen::Vector2d(-edge.y(), edge.x()) / edge.norm();
    const Eigen::Matrix2d bend = -slope / edge.norm() * across * across.transpose();
    term.model.hessian.block<2, 2>(0, 0) += bend;
    term.model.hessian.block<2, 2>(2, 2) += bend;
    term.model.hessian.block<2, 2>(0, 2) -= bend;
    term.model.hessian.block<2, 2>(2, 0) -= bend;
  });
  return terms;
}

bool CrossesItself(std::span<const Eigen::Vector2d> frame) {
  const size_t n = frame.size();
  for (size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d &a = frame[i], &b = frame[(i + 1) % n];
    for (size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k == n - 1) continue;
      const Eigen::Vector2d &c = frame[k], &d = frame[(k + 1) % n];
      if (BoxesMeet(a, b, c, d) && ExactTurn(a, b, c) * ExactTurn(a, b, d) <= 0 &&
          ExactTurn(c, d, a) * ExactTurn(c, d, b) <= 0)
        return true;
    }
    // Adjacent edges must not fold back on each other.
    const Eigen::Vector2d& next = frame[(i + 2) % n];
    if (ExactTurn(a, b, next) == 0 && (b - a).dot(next - b) <= 0) return true;
  }
  return false;
}

}  // namespace slicefarm::texture
