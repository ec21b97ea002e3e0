#pragma once

#include <Eigen/Core>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// A number by vertex whose levels are lines along `direction` in the map: straight ones, which lie
/// as far apart on the surface as the map's stretch makes them. Unit: mm of the map.
std::vector<double> StraightField(const SurfaceMap& map, const Eigen::Vector2d& direction);

/// One whose levels lie as far apart on the surface as they differ, wherever the surface lets them:
/// a field next to the straight one whose gradients are within 5 % of length 1, but for few places.
/// Lines bend for it, and where a surface shrinks or bulges some end or begin in ridges of the
/// field. A ridge is a strip of triangles, so fine meshes are more even.
///
/// Steps: each gradient is scaled towards length 1, and the field whose gradients are next to those
/// (a sparse system, factored once) is the next one; first by least squares, then by the least sum
/// of what gradients are off, which gathers what cannot be even in few places. Errors: INTERNAL;
/// Cancelled. Cost: one factorization and 10 to 400 solutions.
/// Source: the eikonal equation |grad f| = 1 by local/global steps as of Sorkine and Alexa,
/// "As-Rigid-As-Possible Surface Modeling", SGP 2007, then by ADMM (Boyd et al. 2011, section 6.1).
absl::StatusOr<std::vector<double>> EquidistantField(const SurfaceMap& map,
                                                     const Eigen::Vector2d& direction,
                                                     const CancelToken& cancel = {});

/// The length of the field's gradient on a triangle of the surface: levels that differ by 1 lie 1 /
/// that apart.
double GradientLength(const SurfaceMap& map, const std::vector<double>& field, int32_t triangle);

/// Levels `spacing` apart that leave equal margins: at low + (l - (n - 1) spacing) / 2 + i spacing,
/// n = floor(l / spacing) of the length l = high - low, or the middle alone. REQUIRES: spacing > 0.
std::vector<double> CentredLevels(double low, double high, double spacing);

}  // namespace slicefarm::texture
