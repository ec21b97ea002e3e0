#pragma once

#include <Eigen/Core>
#include <vector>

#include "absl/functional/function_ref.h"

namespace slicefarm::milling {

/// Height of the tip where it rests, by place; minus infinity where nothing is under it.
using SurfaceHeight = absl::FunctionRef<double(const Eigen::Vector2d&)>;

/// The tip's way over the surface between two places on it, from above a straight line: its points
/// behind `from`, `to` last. Chords are off by a tenth of the tolerance at most, as far as three
/// places within each tell; at steps of the surface, where none can follow, they are a quarter of
/// the tolerance long. Where nothing is under the tip it goes straight. Units: mm.
std::vector<Eigen::Vector3d> SurfaceWay(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                        double tolerance_mm, SurfaceHeight height);

}  // namespace slicefarm::milling
