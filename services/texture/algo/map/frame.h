#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "services/texture/algo/map/distortion.h"

namespace slicefarm::texture {

/// What keeps a frame from crossing itself: a point that comes near an edge pushes back. A closed
/// ring of points, of which the places change.
///
/// For an edge ab and a point p the measure is d = |pa| + |pb| - |ab|: above 0 off the edge,
/// smooth. A pair costs (1 - s/d)^2 where d < s, a quarter of the edges' mean length. Source: Su,
/// Ye, Liu, Fu 2020, section 4.2.
class FrameBarrier {
 public:
  /// An edge from `a` to `b` and a point off it, by place in the frame.
  struct Pair {
    int32_t a = 0;
    int32_t b = 0;
    int32_t point = 0;
  };
  struct Term {
    Pair pair;
    LocalModel model;  ///< by a, b, point
  };

  explicit FrameBarrier(std::span<const Eigen::Vector2d> frame);

  double Energy(std::span<const Eigen::Vector2d> frame) const;
  std::vector<Term> Terms(std::span<const Eigen::Vector2d> frame) const;

 private:
  double reach_ = 0;
};

/// Whether edges of the ring meet other than at a common end. Cost: O(n^2) for n points.
bool CrossesItself(std::span<const Eigen::Vector2d> frame);

}  // namespace slicefarm::texture
