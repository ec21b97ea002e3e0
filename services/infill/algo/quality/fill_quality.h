#pragma once

#include <cstdint>
#include <span>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Quality figures of the paths that fill a region.
struct FillQuality {
  /// Plastic of the paths as a share of the plastic that would fill the region; to be compared with
  /// the requested density.
  double got = 0;
  double covered = 0;  ///< share of the region under beads (bead_cover.h)
  int64_t paths = 0;
  double length_mm = 0;
  double longest_mm = 0;
  /// Total length of the travels between paths, if each travel leads to the nearest end of all
  /// remaining paths.
  double travel_mm = 0;
  /// Evenness of the directions, in [0, 1]: the smallest eigenvalue of the mean of d d^T, divided
  /// by the largest, with d the unit direction at each point of the paths. 1: the same length in
  /// all directions; 0: all lines are parallel.
  double isotropy = 0;
  /// Locality of the longest path: the greatest |p_i - p_j|^2 / |i - j|, with distances in
  /// spacings. The points p_i are one spacing apart along the path. Hilbert's curve is below 6,
  /// Peano's below 8. A path of more than kMostLocalityPlaces points is sampled at this number of
  /// points. 0: no path.
  double locality = 0;
};
/// Largest number of points at which the locality of a path is computed.
inline constexpr int kMostLocalityPlaces = 2'000;

/// Returns the quality figures of paths in a layer of height `height_nm`. `spacing_nm`: spacing of
/// beads side by side, which is the unit of locality. Cost: the cost of CoveredShare, O(paths^2)
/// for travel, O(points^2) of the sampled path for locality.
FillQuality QualityOf(const MultiPolygon& region, std::span<const Path> paths, Coord height_nm,
                      Coord spacing_nm);

/// Lower and upper bound of a property of the infill, as if it were a homogeneous material.
struct PropertyBounds {
  double least = 0;
  double most = 0;
};

/// Returns bounds of Young's modulus of infill with the density rho, as a share of the material's
/// modulus. Upper bound: walls under tension (Voigt), rho. Lower bound: walls that bend in an open
/// cell (L. J. Gibson, M. F. Ashby, "Cellular solids"), rho^2.
PropertyBounds StiffnessBounds(double density);

/// Returns bounds of the conductivity of infill with this density: `material` and `air` are the
/// conductivities of the plastic and of the air, in any common unit. Upper bound: plastic and air
/// side by side; lower bound: one behind the other. REQUIRES: both conductivities are above 0.
PropertyBounds ConductivityBounds(double density, double material, double air);

}  // namespace slicefarm::infill
