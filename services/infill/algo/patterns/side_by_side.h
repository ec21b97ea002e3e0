#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Returns the pieces of a pattern inside a region. If the pattern takes several lines, a group of
/// context.shape.lines lines replaces each line. Lines of one group are a spacing apart. Groups are
/// so far apart that the length per area remains 1 / pitch.
///
/// Patterns of straight lines and of loops lay out their groups themselves. Other curves become the
/// outlines of strips around them. So lines of a group never overlap, not even in tight bends and
/// where curves touch. Errors: see MakePattern. Cost: the cost of the pattern; for curves also a
/// union of strips for every two lines of a group.
absl::StatusOr<std::vector<Piece>> PiecesOfPattern(FillPattern pattern, const MultiPolygon& region,
                                                   const PatternContext& context);

}  // namespace slicefarm::infill
