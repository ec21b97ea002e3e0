#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/lines/piece.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Returns the pieces of families of parallel lines inside a region, family by family. Errors:
/// REQUEST_TOO_LARGE (see CutLines). Cost: the cost of CutLines for each family.
absl::StatusOr<std::vector<Piece>> StraightPieces(const MultiPolygon& region,
                                                  std::span<const LineFamily> families);

}  // namespace slicefarm::infill
