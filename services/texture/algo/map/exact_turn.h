#pragma once

#include <Eigen/Core>

namespace slicefarm::texture {

/// 1 if a, b, c turn left, -1 right, 0 if they lie on a line; exact for all finite doubles.
int ExactTurn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace slicefarm::texture
