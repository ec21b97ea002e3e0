#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "services/texture/algo/map/distortion.h"

namespace slicefarm::texture {

/// Barrier that prevents a frame from crossing itself: its energy pushes points away from close
/// edges. A frame is a closed ring of points that move (the outer boundary of the shell, shell.h).
///
/// For an edge ab and a point p the measure is d = |pa| + |pb| - |ab|, which is smooth, and
/// positive if p is not on the edge. A pair adds the energy (1 - s/d)^2 if d < s, where s is a
/// quarter of the mean edge length. Source: Su, Ye, Liu, Fu 2020, section 4.2.
class FrameBarrier {
 public:
  /// Edge from `a` to `b`, and a point that is none of its ends. All three are indices in the
  /// frame.
  struct Pair {
    int32_t a = 0;
    int32_t b = 0;
    int32_t point = 0;
  };
  /// Model of the energy of one pair.
  struct Term {
    Pair pair;
    LocalModel model;  ///< model in the coordinates of a, b and the point
  };

  explicit FrameBarrier(std::span<const Eigen::Vector2d> frame);

  /// Returns the energy of all pairs.
  double Energy(std::span<const Eigen::Vector2d> frame) const;
  /// Returns the models of all pairs with an energy above 0.
  std::vector<Term> Terms(std::span<const Eigen::Vector2d> frame) const;

 private:
  double reach_ = 0;
};

/// Returns true if edges of the ring meet anywhere but at a common end. Cost: O(n^2) for n points.
bool CrossesItself(std::span<const Eigen::Vector2d> frame);

}  // namespace slicefarm::texture
