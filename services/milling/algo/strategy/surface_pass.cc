#include "services/milling/algo/strategy/surface_pass.h"

#include <cmath>

namespace slicefarm::milling {
namespace {

/// Shares of the tolerance: kOffShare for the deviation of chords, the other one for the length of
/// chords at a step of the surface.
constexpr double kOffShare = 0.1;
constexpr double kStepShare = 0.25;

class SurfaceWalk {
 public:
  SurfaceWalk(double tolerance_mm, SurfaceHeight height)
      : off_mm_(kOffShare * tolerance_mm), step_mm_(kStepShare * tolerance_mm), height_(height) {}

  Eigen::Vector3d Halfway(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    const Eigen::Vector2d place = (a.head<2>() + b.head<2>()) / 2;
    return {place.x(), place.y(), height_(place)};
  }

  /// Adds the points between `a` and `b`. Tests three points: at the foot of a step, the middle
  /// alone could be on the chord by chance.
  void Add(const Eigen::Vector3d& a, const Eigen::Vector3d& middle, const Eigen::Vector3d& b) {
    const Eigen::Vector3d before = Halfway(a, middle), after = Halfway(middle, b);
    const bool known =
        std::isfinite(before.z()) && std::isfinite(middle.z()) && std::isfinite(after.z());
    const auto off = [&](const Eigen::Vector3d& p, double share) {
      return std::abs(p.z() - (a.z() + share * (b.z() - a.z()))) > off_mm_;
    };
    const bool bent = off(before, 0.25) || off(middle, 0.5) || off(after, 0.75);
    if (bent && known && (b - a).head<2>().norm() > step_mm_) {
      Add(a, before, middle);
      Add(middle, after, b);
      return;
    }
    points_.push_back(b);
  }

  std::vector<Eigen::Vector3d> Take() { return std::move(points_); }

 private:
  double off_mm_;
  double step_mm_;
  SurfaceHeight height_;
  std::vector<Eigen::Vector3d> points_;
};

}  // namespace

std::vector<Eigen::Vector3d> SurfacePass(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                         double tolerance_mm, SurfaceHeight height) {
  SurfaceWalk walk(tolerance_mm, height);
  walk.Add(from, walk.Halfway(from, to), to);
  return walk.Take();
}

}  // namespace slicefarm::milling
