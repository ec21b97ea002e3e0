#pragma once

#include <cstdint>
#include <span>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Quality figures of the paths that fill a region.
struct FillQuality {
  double got = 0;      ///< plastic / plastic of a full region; to be compared with the density
  double covered = 0;  ///< share of the region under beads (bead_cover.h)
  int64_t paths = 0;
  double length_mm = 0;
  double longest_mm = 0;
  double travel_mm = 0;  ///< travel between paths, always to the nearest remaining end
  /// Evenness of the directions, [0, 1]: the least divided by the greatest eigenvalue of the mean
  /// of d d^T, d the direction. 1: the same length in all directions; 0: all lines are parallel.
  double isotropy = 0;
  /// Locality of the longest path: the greatest |p_i - p_j|^2 / |i - j| of points one spacing apart
  /// along it, in spacings. Hilbert's curve is below 6, Peano's below 8. A path of more than
  /// kMostLocalityPlaces points is sampled with this number of points. 0: no path.
  double locality = 0;
};
/// Largest number of points for the locality of a path.
inline constexpr int kMostLocalityPlaces = 2'000;

/// Returns the quality figures of paths. `spacing_nm`: spacing of beads side by side, which is the
/// unit of locality. Cost: the cost of CoveredShare, O(paths^2) for travel, O(places^2) for
/// locality.
FillQuality QualityOf(const MultiPolygon& region, std::span<const Path> paths, Coord height_nm,
                      Coord spacing_nm);

/// Bounds of a property of the whole, from the property of the material and the density.
struct PropertyBounds {
  double least = 0;
  double most = 0;
};

/// Returns bounds of Young's modulus, as a share of the material's. Upper bound: walls under
/// tension (Voigt), rho. Lower bound: walls that bend in an open cell (L. J. Gibson, M. F. Ashby,
/// "Cellular solids"), rho^2.
PropertyBounds StiffnessBounds(double density);

/// Returns bounds of the conductivity of a material in air, in their unit. Upper bound: side by
/// side; lower bound: one behind the other. REQUIRES: both conductivities are above 0.
PropertyBounds ConductivityBounds(double density, double material, double air);

}  // namespace slicefarm::infill
