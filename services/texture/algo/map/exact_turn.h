#pragma once

#include <Eigen/Core>

namespace slicefarm::texture {

/// Returns 1 if a, b, c turn left, -1 if they turn right, 0 if they are on a line. Exact for all
/// finite doubles.
int ExactTurn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

}  // namespace slicefarm::texture
