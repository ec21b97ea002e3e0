#pragma once

#include <Eigen/Core>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// Returns a field (one value per vertex) that is linear in the map and grows to the left of
/// `direction`. The lines at which the field has a constant value are therefore straight and have
/// this direction. Their distance on the surface depends on the map's stretch. Unit: mm of the map.
std::vector<double> StraightField(const SurfaceMap& map, const Eigen::Vector2d& direction);

/// Returns a field with evenly spaced levels: on the surface, the distance between two levels
/// (lines of constant value) equals the difference of their values, as far as the surface allows.
/// The result is the field closest to the straight one with gradients within 5 % of length 1,
/// except in a few areas. The lines bend. Where a surface shrinks or bulges, some lines end or
/// begin in ridges of the field. A ridge is a strip of triangles, so lines on fine meshes are more
/// even.
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

/// Returns the values of evenly spaced levels, `spacing` apart, with equal margins at both ends:
/// low + (l - (n - 1) spacing) / 2 + i spacing. Here l = high - low and n = floor(l / spacing). If
/// n is 0, the result is only the middle. REQUIRES: spacing > 0.
std::vector<double> CentredLevels(double low, double high, double spacing);

}  // namespace slicefarm::texture
