#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/fill_patterns.h"
#include "common/model/path.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// A lone path of a pattern by law is worth a travel from this many widths on: it would be a dot
/// in a corner, of 0.1 mm3 at most, which no wall and no line needs.
inline constexpr double kMinLoneWidths = 2.5;

struct SparseFill {
  FillPattern pattern = FillPattern::kGrid;
  double density = 0.2;  ///< (0, 1]
  double angle_rad = 0;
  int32_t layer = 0;  ///< of the object's own
  Coord z_nm = 0;     ///< of the layer's middle, above the object's bottom
  Coord width_nm = 450'000;
  Coord height_nm = 200'000;
  Coord overlap_nm = 0;     ///< how much nearer than half a spacing lines come to the region's edge
  Coord anchor_nm = 0;      ///< how far a loose end turns along the edge
  Coord anchor_max_nm = 0;  ///< longest link; 0: none
  Coord smoothing_nm = 0;   ///< of medial-axis lines; 0: none
  std::span<const Polyline> planned = {};  ///< of patterns that planning lays out
  const LayerField* field = nullptr;       ///< says how dense, in place of `density`, and which way
};

/// Fills a region with a pattern of the given density: path length per area is density / spacing,
/// exactly, two widths inside the edge and deeper. Links and anchors along the edge join the lines to
/// long paths and hold them to the walls (LinkedPaths): beads of the same width, on top of that
/// length. Patterns whose lines run along the edge begin at it. Places so narrow that beads along
/// both sides would lie on each other stay empty, and lone paths shorter than two and a half widths
/// of patterns with a law.
///
/// With a field the same holds at each place, as PiecesOfField says. Lines of a dithered one have up
/// to 15 % more or less plastic, so that the lines of a layer are what the field asks for in all.
///
/// Errors: as MakePattern. Cost: O(n log n) for the inset, and the pattern's and LinkedPaths' own.
absl::StatusOr<std::vector<Path>> FillSparse(const MultiPolygon& region, const SparseFill& fill);

}  // namespace slicefarm::infill
