#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/fill_patterns.h"
#include "common/model/options/pattern_options.h"
#include "common/model/path.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// Smallest length, in widths, of a single path of a pattern with lines that follow from a formula.
/// A shorter path is not worth a travel: it is a dot in a corner, of at most 0.1 mm3, which
/// supports neither wall nor line.
inline constexpr double kMinLoneWidths = 2.5;

/// Parameters of FillSparse.
struct SparseFill {
  FillPattern pattern = FillPattern::kGrid;
  double density = 0.2;  ///< density in (0, 1]
  double angle_rad = 0;
  int32_t layer = 0;  ///< index of the layer in the object
  Coord z_nm = 0;     ///< height of the layer's middle above the object's bottom
  Coord width_nm = 450'000;
  Coord height_nm = 200'000;
  /// Distance by which lines may be nearer to the region's boundary than half a spacing.
  Coord overlap_nm = 0;
  /// length in nm for which a path continues along the boundary at a loose end
  Coord anchor_nm = 0;
  Coord anchor_max_nm = 0;  ///< longest link; 0: no links
  Coord smoothing_nm = 0;   ///< length in nm over which medial-axis lines are smoothed; 0: none
  std::span<const Polyline> planned = {};  ///< lines of patterns that planning lays out
  PatternOptions shape = {};
  /// Fields that give the density (instead of `density`) and the directions at each point; null:
  /// none.
  const LayerField* field = nullptr;
};

/// Fills a region with a pattern of the given density. At two widths from the boundary and deeper,
/// path length per area is exactly density / spacing. Links and anchors along the boundary join the
/// lines into long paths and attach them to the walls (LinkedPaths). Links and anchors are beads of
/// the same width; their length is additional. Patterns with lines along the boundary begin at the
/// boundary. Parts so narrow that beads along both sides would overlap stay empty. Paths shorter
/// than kMinLoneWidths are omitted if the lines of the pattern follow from a formula.
///
/// With a field, the density is correct at each point, see PiecesOfField. With a dithered field,
/// one factor of 0.85 to 1.15 scales the plastic of all beads of a layer. The layer's total then
/// equals the total of the field.
///
/// Errors: REQUEST_TOO_LARGE or SETTING_OUT_OF_RANGE, see MakePattern and CheckRingSpacing. Cost:
/// O(n log n) for the inset, n points, and the cost of the pattern and of LinkedPaths.
absl::StatusOr<std::vector<Path>> FillSparse(const MultiPolygon& region, const SparseFill& fill);

}  // namespace slicefarm::infill
