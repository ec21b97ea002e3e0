#pragma once

#include <Eigen/Core>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// Returns a field (one value per vertex) with levels that are straight lines along `direction` in
/// the map. Their distance on the surface depends on the map's stretch. Unit: mm of the map.
std::vector<double> StraightField(const SurfaceMap& map, const Eigen::Vector2d& direction);

/// Returns a field with levels that have a distance on the surface equal to the difference of their
/// values, as far as the surface allows. It is the field closest to the straight one with gradients
/// within 5 % of length 1, except in a few areas. The lines bend, and where a surface shrinks or
/// bulges, some lines end or begin in ridges of the field. A ridge is a strip of triangles, so fine
/// meshes are more even.
///
/// Each step scales all gradients towards length 1. Then it finds the field with gradients closest
/// to the scaled ones (a sparse system, factored once). The first steps use least squares. The
/// later ones minimize the sum of the gradients' errors, which concentrates unavoidable errors in
/// small areas. Errors: INTERNAL; Cancelled. Cost: one factorization and 10 to 400 solutions.
///
/// Source: the eikonal equation |grad f| = 1 by local/global steps as in Sorkine and Alexa,
/// "As-Rigid-As-Possible Surface Modeling", SGP 2007, then by ADMM (Boyd et al. 2011, section 6.1).
absl::StatusOr<std::vector<double>> EquidistantField(const SurfaceMap& map,
                                                     const Eigen::Vector2d& direction,
                                                     const CancelToken& cancel = {});

/// Returns the length of the field's gradient on a triangle of the surface. The distance between
/// levels that differ by 1 is the inverse of this length.
double GradientLength(const SurfaceMap& map, const std::vector<double>& field, int32_t triangle);

/// Returns levels with distance `spacing` and equal margins: low + (l - (n - 1) spacing) / 2 + i
/// spacing. Here l = high - low and n = floor(l / spacing). If n is 0, it returns only the middle.
/// REQUIRES: spacing > 0.
std::vector<double> CentredLevels(double low, double high, double spacing);

}  // namespace slicefarm::texture
