#pragma once

#include <cstdint>
#include <span>

#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// How good the paths that fill a region are.
struct FillQuality {
  double got = 0;      ///< plastic / what would fill the region: to be compared with the density
  double covered = 0;  ///< share of the region that lies under beads (bead_cover.h)
  int64_t paths = 0;
  double length_mm = 0;
  double longest_mm = 0;
  double travel_mm = 0;  ///< between paths, always on to the nearest end that is left
  /// How evenly lengths are spread over directions, [0, 1]: the least by the greatest eigenvalue of
  /// the mean of d d^T, d the direction. 1: the same in all; 0: all lines are parallel.
  double isotropy = 0;
  /// How far the longest path strays: the greatest |p_i - p_j|^2 / |i - j| of places one spacing
  /// apart along it, in spacings (Hilbert's curve stays below 6, Peano's below 8). Of paths of more
  /// than kMostLocalityPlaces, of as many spread over it. 0: no path.
  double locality = 0;
};
inline constexpr int kMostLocalityPlaces = 2'000;

/// `spacing_nm`: of beads that lie side by side; it makes the unit of locality.
/// Cost: that of CoveredShare, O(paths^2) for travel, O(places^2) for locality.
FillQuality QualityOf(const MultiPolygon& region, std::span<const Path> paths, Coord height_nm,
                      Coord spacing_nm);

/// What is known of a property of the whole from that of the material and its density.
struct PropertyBounds {
  double least = 0;
  double most = 0;
};

/// Young's modulus, as a share of the material's. Most: walls that are stretched (Voigt), rho.
/// Least: walls that bend in a cell open on all sides (L. J. Gibson, M. F. Ashby, "Cellular
/// solids"), rho^2.
PropertyBounds StiffnessBounds(double density);

/// Conductivity of a material in air, in their unit. Most: side by side; least: one behind the
/// other. REQUIRES: both conductivities are above 0.
PropertyBounds ConductivityBounds(double density, double material, double air);

}  // namespace slicefarm::infill
