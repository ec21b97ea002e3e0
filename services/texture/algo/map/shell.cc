#include "services/texture/algo/map/shell.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/base/error.h"
#include "common/base/portable_math.h"

namespace slicefarm::texture {
namespace {

constexpr double kFrameRadius = 1.05;  // multiple of the map's circle
constexpr int kLeastFrame = 24, kMostFrame = 200;
constexpr int kLoopPerFrame = 5;  // points of the loop per point of the frame

/// Indices of the points of a ring, counter-clockwise.
using Ring = std::vector<int32_t>;

class ShellMaker {
 public:
  explicit ShellMaker(std::span<const Eigen::Vector2d> map) : map_(map) {}

  void AddRings(const BoundaryLoop& loop);
  void FillHole(const BoundaryLoop& hole, const Eigen::Vector2d& middle);
  bool AllTurnLeft() const;
  Shell Take() { return std::move(shell_); }

 private:
  Eigen::Vector2d At(int32_t point) const {
    const auto i = static_cast<size_t>(point);
    return i < map_.size() ? map_[i] : shell_.points[i - map_.size()];
  }
  int32_t Add(const Eigen::Vector2d& point) {
    shell_.points.push_back(point);
    return static_cast<int32_t>(map_.size() + shell_.points.size()) - 1;
  }
  void Join(const Ring& inner, const Ring& outer);
  Ring Coarser(const Ring& ring, double radius, double most_gap);
  Ring EvenRing(size_t count, double radius, const Eigen::Vector2d& towards);

  std::span<const Eigen::Vector2d> map_;
  Shell shell_;
};

/// Returns a ring farther out with every second point, and with additional points in gaps, so that
/// no chord crosses the inner ring.
Ring ShellMaker::Coarser(const Ring& ring, double radius, double most_gap) {
  std::vector<double> angles;
  for (const int32_t point : ring) angles.push_back(Atan2(At(point).y(), At(point).x()));
  const auto gap = [&](size_t from, size_t to) {
    const double turn = angles[to % ring.size()] - angles[from];
    return turn > 0 ? turn : turn + 2 * std::numbers::pi;
  };
  Ring next;
  for (size_t i = 0; i < ring.size();) {
    const bool skip = i + 2 <= ring.size() && gap(i, i + 2) < most_gap;
    const size_t to = skip ? i + 2 : i + 1;
    const auto parts = static_cast<int>(std::ceil(gap(i, to) / most_gap));
    for (int k = 0; k < parts; ++k) {
      const double angle = angles[i] + gap(i, to) * k / parts;
      next.push_back(Add(radius * Eigen::Vector2d(Cos(angle), Sin(angle))));
    }
    i = to;
  }
  return next;
}

Ring ShellMaker::EvenRing(size_t count, double radius, const Eigen::Vector2d& towards) {
  const double start = Atan2(towards.y(), towards.x());
  Ring ring;
  for (size_t i = 0; i < count; ++i) {
    const double angle =
        start + 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    ring.push_back(Add(radius * Eigen::Vector2d(Cos(angle), Sin(angle))));
  }
  return ring;
}

/// Adds the triangles between two rings. Both rings begin in the same direction from the origin. Of
/// two possible diagonals, the shorter one is used.
void ShellMaker::Join(const Ring& inner, const Ring& outer) {
  size_t i = 0, o = 0;
  while (i < inner.size() || o < outer.size()) {
    const int32_t a = inner[i % inner.size()], next_a = inner[(i + 1) % inner.size()];
    const int32_t b = outer[o % outer.size()], next_b = outer[(o + 1) % outer.size()];
    const bool inwards = o == outer.size() ||
                         (i < inner.size() &&
                          (At(next_a) - At(b)).squaredNorm() < (At(next_b) - At(a)).squaredNorm());
    if (inwards) {
      shell_.triangles.push_back({b, next_a, a});
      ++i;
    } else {
      shell_.triangles.push_back({a, b, next_b});
      ++o;
    }
  }
}

void ShellMaker::AddRings(const BoundaryLoop& loop) {
  const auto frame_points = static_cast<size_t>(
      std::clamp(static_cast<int>(loop.size()) / kLoopPerFrame, kLeastFrame, kMostFrame));
  size_t rings = 1;
  for (size_t n = loop.size() / 2; n > frame_points; n /= 2) ++rings;
  const double radius = map_[static_cast<size_t>(loop[0])].norm();
  Ring ring = loop;
  for (size_t k = 1; k <= rings; ++k) {
    const double here =
        radius * (1 + (kFrameRadius - 1) * static_cast<double>(k) / static_cast<double>(rings));
    const double before = At(ring[0]).norm();
    const double most_gap = 1.4 * Acos(before / here);
    Ring next =
        k == rings ? EvenRing(frame_points, here, At(ring[0])) : Coarser(ring, here, most_gap);
    Join(ring, next);
    ring = std::move(next);
  }
  shell_.frame = std::move(ring);
}

void ShellMaker::FillHole(const BoundaryLoop& hole, const Eigen::Vector2d& middle) {
  const int32_t centre = Add(middle);
  // The loop has the surface on its left, so the hole is on its right.
  for (size_t i = 0; i < hole.size(); ++i)
    shell_.triangles.push_back({hole[(i + 1) % hole.size()], hole[i], centre});
}

bool ShellMaker::AllTurnLeft() const {
  return std::all_of(shell_.triangles.begin(), shell_.triangles.end(), [&](const auto& t) {
    const Eigen::Vector2d a = At(t[1]) - At(t[0]), b = At(t[2]) - At(t[0]);
    return a.x() * b.y() - a.y() * b.x() > 0;
  });
}

}  // namespace

absl::StatusOr<Shell> ShellAround(const FirstMap& map, std::span<const BoundaryLoop> loops) {
  ShellMaker maker(map.points);
  maker.AddRings(loops[0]);
  for (size_t i = 1; i < loops.size(); ++i) maker.FillHole(loops[i], map.hole_middles[i - 1]);
  if (!maker.AllTurnLeft())
    return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                     "a first map's boundary has no shell around it");
  return maker.Take();
}

}  // namespace slicefarm::texture
