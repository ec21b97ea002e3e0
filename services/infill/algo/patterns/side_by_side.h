#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Returns the pieces of a pattern inside a region, with place.shape.lines lines side by side in
/// place of each line if the pattern takes several lines. Groups of lines are so far apart that the
/// length per area remains 1 / pitch. Lines of one group are a spacing apart.
///
/// Patterns of straight lines and of loops lay out their groups themselves. Other curves become the
/// outlines of strips around them. So lines of a group never overlap, not even in tight bends and
/// where curves touch. Errors: see MakePattern. Cost: the cost of the pattern; for curves also a
/// union of strips for every two lines of a group.
absl::StatusOr<std::vector<Piece>> PiecesOfPattern(FillPattern pattern, const MultiPolygon& region,
                                                   const PatternContext& context);

}  // namespace slicefarm::infill
