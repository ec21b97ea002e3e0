#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/fields/density_levels.h"
#include "services/infill/algo/fields/layer_field.h"
#include "services/infill/algo/lines/piece.h"
#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Returns true if the field's density is produced by parts of the region that are each filled with
/// one constant density. The parts are dithered cells, or density levels if the lines of `pattern`
/// cannot be graded. Returns false for a field with directions.
bool IsInParts(FillPattern pattern, const LayerField& field);

/// Returns the parts of a region with their densities. REQUIRES: IsInParts is true for `field`.
/// Errors: REQUEST_TOO_LARGE for more than kMaxFieldCells.
absl::StatusOr<std::vector<DensityPart>> PartsOfField(const MultiPolygon& region,
                                                      const LayerField& field);

/// Fills a region with the density of a field. A field with directions gives streamlines
/// (Streamlines). Other fields use the lines of `pattern`, graded (GradedPieces) or in parts
/// (IsInParts). In parts, lines end at the boundary of their part, and lines that follow this
/// boundary keep half a pitch from other parts. `context` gives all parameters of the pattern
/// except the pitch. Errors: REQUEST_TOO_LARGE for too many cells, lines or points; other errors of
/// `pattern`, see its MakePattern.
absl::StatusOr<std::vector<Piece>> PiecesOfField(const MultiPolygon& region, FillPattern pattern,
                                                 const PatternContext& context,
                                                 const LayerField& field);

}  // namespace slicefarm::infill
