#pragma once

#include <vector>

#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

struct SerpentineOptions {
  /// Every piece of line is printed after all pieces of the line below that it lies beside: then
  /// each new bead leans on one neighbour, from the same side all over the region, which gives an
  /// even surface.
  bool monotonic = false;
  /// Neighbouring ends are joined along the boundary up to this far, those on the same line where
  /// no other way leads on; farther ones are left to a travel.
  double max_link_nm = 0;
  double min_length_nm = 0;  ///< shorter paths are left out
};

struct SerpentinePath {
  Polyline points;
  /// Places in `points` at which the pieces of line begin; each ends at the next point. What lies
  /// between two pieces is their link along the boundary.
  std::vector<int32_t> pieces;
  std::vector<int32_t> places;  ///< in ScanLines::order, of the crossings at which they begin
  /// The links, by the crossing from which each one runs forwards along its ring.
  std::vector<int32_t> stretches;
};

/// Joins pieces of scan lines to long back-and-forth paths. Neighbouring ends are joined along the
/// boundary, so the paths stay in the region. In the order of printing where `monotonic`; else the
/// order says nothing.
///
/// Every piece is in exactly one path, and no stretch of boundary is used twice.
/// Cost: O(n + k), n points of the region, k pieces (O(n + k log k) if monotonic).
std::vector<SerpentinePath> Serpentine(const ScanLines& lines, const SerpentineOptions& options);

}  // namespace slicefarm::infill
