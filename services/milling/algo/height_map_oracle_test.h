#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "services/milling/algo/motion/mill_program.h"

namespace slicefarm::milling {

/// Height map with pixels of 0.05 mm that checks a program. The cutter is placed every 0.04 mm of
/// each move. It shares only the cutter's outline with the product code.
class HeightMapOracle {
 public:
  static constexpr double kPixel = 0.05;
  static constexpr double kStep = 0.04;
  static constexpr double kTolerance = 0.03;  ///< error of pixels and steps beside walls

  HeightMapOracle(const MillingJob& job, std::function<double(double, double)> part)
      : job_(job), part_(std::move(part)), low_(job.stock_box.min().head<2>()) {
    const Eigen::Vector3d size = job.stock_box.sizes();
    nx_ = static_cast<int>(std::lround(size.x() / kPixel));
    ny_ = static_cast<int>(std::lround(size.y() / kPixel));
    heights_.assign(static_cast<size_t>(nx_) * ny_, job.stock_box.max().z());
  }

  void Run(const MillProgram& program) {
    for (size_t i = 1; i < program.moves.size(); ++i) {
      const MillMove& move = program.moves[i];
      Eigen::Vector3d from = program.moves[i - 1].to_mm;
      for (const Eigen::Vector3d& to : PointsOf(move, from, 1e-3)) {
        const double steps = std::max(1.0, std::ceil((to - from).norm() / kStep));
        for (double k = 0; k <= steps; ++k) Put(from + (to - from) * (k / steps), move);
        from = to;
      }
    }
  }

  /// Returns the deepest cut below the part, with a sideways tolerance at walls.
  double Gouge() const {
    double deepest = 0;
    ForEach([&](double x, double y, double height) {
      double least = part_(x, y);
      for (const double dx : {-kTolerance, 0.0, kTolerance})
        for (const double dy : {-kTolerance, 0.0, kTolerance})
          least = std::min(least, part_(x + dx, y + dy));
      deepest = std::max(deepest, least - height);
    });
    return deepest;
  }

  /// Returns the highest stock above the surface that the cutter can reach: the closing of the part
  /// by the cutter.
  double LeftReachable() {
    const int margin = static_cast<int>(job_.options.cutter.radius_mm() / kPixel) + 2;
    const int wx = nx_ + 2 * margin, wy = ny_ + 2 * margin;
    std::vector<double> part(static_cast<size_t>(wx) * wy);
    for (int j = 0; j < wy; ++j)
      for (int i = 0; i < wx; ++i)
        part[static_cast<size_t>(j) * wx + i] =
            std::max(job_.floor_mm, part_(X(i - margin), Y(j - margin)));
    std::vector<double> tips = Spread(part, wx, wy);
    for (double& z : tips) z = -z;
    const std::vector<double> reach = Spread(tips, wx, wy);
    double left = 0;
    for (int j = 1; j + 1 < ny_; ++j) {
      for (int i = 1; i + 1 < nx_; ++i) {
        double most = -1e9;  // beside a wall the pixel on the other side counts
        for (int v = -1; v <= 1; ++v)
          for (int u = -1; u <= 1; ++u)
            most =
                std::max(most, -reach[static_cast<size_t>(j + v + margin) * wx + i + u + margin]);
        const double height = heights_[static_cast<size_t>(j) * nx_ + i];
        if (height - most > left) left_at_ = {X(i), Y(j), height};
        left = std::max(left, height - most);
      }
    }
    return left;
  }

  Eigen::Vector3d left_at() const { return left_at_; }
  double rapid_in_stock() const { return rapid_in_stock_; }
  double deepest_tip() const { return deepest_tip_; }

 private:
  double X(int i) const { return low_.x() + (i + 0.5) * kPixel; }
  double Y(int j) const { return low_.y() + (j + 0.5) * kPixel; }

  template <typename Visit>
  void ForEach(Visit visit) const {
    for (int j = 0; j < ny_; ++j)
      for (int i = 0; i < nx_; ++i) visit(X(i), Y(j), heights_[static_cast<size_t>(j) * nx_ + i]);
  }

  void Put(const Eigen::Vector3d& tip, const MillMove& move) {
    const double radius = job_.options.cutter.radius_mm();
    deepest_tip_ = std::min(deepest_tip_, tip.z());
    const bool rapid = move.kind == MoveKind::kRapid;
    const int j0 = std::max(0, static_cast<int>((tip.y() - radius - low_.y()) / kPixel) - 1);
    const int i0 = std::max(0, static_cast<int>((tip.x() - radius - low_.x()) / kPixel) - 1);
    for (int j = j0; j < ny_ && Y(j) <= tip.y() + radius; ++j) {
      for (int i = i0; i < nx_ && X(i) <= tip.x() + radius; ++i) {
        double& height = heights_[static_cast<size_t>(j) * nx_ + i];
        const double distance =
            std::sqrt((X(i) - tip.x()) * (X(i) - tip.x()) + (Y(j) - tip.y()) * (Y(j) - tip.y()));
        if (height <= tip.z() || distance > radius) continue;
        const double surface = tip.z() + job_.options.cutter.HeightAt(distance);
        if (surface >= height) continue;
        if (rapid && distance < radius - kTolerance && height - surface > kTolerance)
          rapid_in_stock_ = std::max(rapid_in_stock_, height - surface);
        height = surface;
      }
    }
  }

  /// Returns for each pixel the maximum of all values under the cutter minus its height there.
  std::vector<double> Spread(const std::vector<double>& in, int wx, int wy) const {
    const Cutter& cutter = job_.options.cutter;
    const int m = static_cast<int>(cutter.radius_mm() / kPixel + 1e-9);
    std::vector<double> out(in.size(), -1e9);
    for (int v = -m; v <= m; ++v) {
      for (int u = -m; u <= m; ++u) {
        const double distance = std::sqrt(u * u + v * v) * kPixel;
        if (distance > cutter.radius_mm()) continue;
        const double rise = cutter.HeightAt(distance);
        for (int j = std::max(0, -v); j < std::min(wy, wy - v); ++j)
          for (int i = std::max(0, -u); i < std::min(wx, wx - u); ++i)
            out[static_cast<size_t>(j) * wx + i] =
                std::max(out[static_cast<size_t>(j) * wx + i],
                         in[static_cast<size_t>(j + v) * wx + i + u] - rise);
      }
    }
    return out;
  }

  const MillingJob& job_;
  std::function<double(double, double)> part_;
  Eigen::Vector2d low_;
  int nx_ = 0;
  int ny_ = 0;
  std::vector<double> heights_;
  Eigen::Vector3d left_at_{0, 0, 0};
  double rapid_in_stock_ = 0;
  double deepest_tip_ = 0;
};

}  // namespace slicefarm::milling
