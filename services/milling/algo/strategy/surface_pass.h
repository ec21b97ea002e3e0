#pragma once

#include <Eigen/Core>
#include <vector>

#include "absl/functional/function_ref.h"

namespace slicefarm::milling {

/// Function that returns the height of the tip of the lowered cutter at x, y, in mm; minus infinity
/// if nothing is under the cutter.
using SurfaceHeight = absl::FunctionRef<double(const Eigen::Vector2d&)>;

/// Returns the path of the tip over the surface between two points on it. Seen from above, the path
/// is a straight line. The result has the points after `from`, with `to` as the last one.
///
/// Chords deviate by at most a tenth of the tolerance, tested at three points of each chord. At
/// steps of the surface, where no chord can follow, chords are a quarter of the tolerance long.
/// Where nothing is under the tip, the path is straight. Units: mm.
std::vector<Eigen::Vector3d> SurfacePass(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                         double tolerance_mm, SurfaceHeight height);

}  // namespace slicefarm::milling
