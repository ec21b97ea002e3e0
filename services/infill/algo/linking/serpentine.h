#pragma once

#include <vector>

#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Parameters of Serpentine.
struct SerpentineOptions {
  /// True to print every piece after all pieces beside it on the line below. Each new bead is then
  /// beside one printed bead, on the same side in the whole region, which gives an even surface.
  bool monotonic = false;
  /// Largest length of a link along the boundary. Ends of neighbouring lines are linked; ends of
  /// the same line only if there is no other continuation. Longer distances are travels.
  double max_link_nm = 0;
  double min_length_nm = 0;  ///< smallest length of a path
};

/// Path that consists of pieces of scan lines and of the links between them.
struct SerpentinePath {
  Polyline points;
  /// Indices in `points` at which the pieces begin. Each piece ends at the next point. The points
  /// between two pieces are their link along the boundary.
  std::vector<int32_t> pieces;
  /// Index in ScanLines::order of the crossing at which each piece begins.
  std::vector<int32_t> places;
  /// Index of the crossing at which each link begins; the link follows its ring forwards.
  std::vector<int32_t> stretches;
};

/// Joins pieces of scan lines into long back-and-forth paths. Neighbouring ends are joined along
/// the boundary, so that the paths stay in the region. If `monotonic`, the paths are in the order
/// of printing; otherwise their order has no meaning.
///
/// Every piece is in exactly one path, and no edge part is used twice. Cost: O(n + k), n points of
/// the region, k pieces (O(n + k log k) if monotonic).
std::vector<SerpentinePath> Serpentine(const ScanLines& lines, const SerpentineOptions& options);

}  // namespace slicefarm::infill
