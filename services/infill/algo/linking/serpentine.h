#pragma once

#include <vector>

#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Parameters of Serpentine.
struct SerpentineOptions {
  /// True to print every piece after all pieces beside it on the line below. Each new bead then has
  /// a printed bead beside it on one side, which is the same side in the whole region. This gives
  /// an even surface.
  bool monotonic = false;
  /// Largest length of a link along the boundary, in nm. Links connect ends of neighbouring lines.
  /// They connect ends of the same line only if there is no other continuation. Longer distances
  /// are travels.
  double max_link_nm = 0;
  double min_length_nm = 0;  ///< shorter paths are omitted
};

/// Path that consists of pieces of scan lines and of the links between them.
struct SerpentinePath {
  Polyline points;
  /// Index in `points` of each piece's first point; the next point is the piece's last one. The
  /// points between two pieces are their link along the boundary.
  std::vector<int32_t> pieces;
  /// Index in ScanLines::order of the crossing at which each piece begins.
  std::vector<int32_t> places;
  /// Index in ScanLines::crossings of the crossing from which each link follows its ring forwards.
  /// This is the link's start or its end.
  std::vector<int32_t> spans;
};

/// Joins pieces of scan lines into long back-and-forth paths. Neighbouring ends are joined along
/// the boundary, so that the paths stay in the region. If `monotonic`, the result is in the order
/// of printing; otherwise its order has no meaning.
///
/// Every piece is in exactly one path, unless the path is omitted because it is too short. No part
/// of the boundary is used twice. Cost: O(n + k), n points of the region, k pieces (O(n + k log k)
/// if monotonic).
std::vector<SerpentinePath> Serpentine(const ScanLines& lines, const SerpentineOptions& options);

}  // namespace slicefarm::infill
