#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/fields/density_levels.h"
#include "services/infill/algo/fields/layer_field.h"
#include "services/infill/algo/lines/piece.h"
#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Whether the field is followed in parts, each filled by itself with one density: cells that are
/// dithered, or levels for patterns whose lines cannot be graded.
bool IsInParts(FillPattern pattern, const LayerField& field);

/// REQUIRES: IsInParts. Errors: those of LevelParts and DitheredRegion.
absl::StatusOr<std::vector<DensityPart>> PartsOfField(const MultiPolygon& region,
                                                      const LayerField& field);

/// Fills a region as a field asks for: with streamlines, if it has directions; else with the lines
/// of `pattern`, graded (GradedPieces), or in parts: lines end where their part does, and curves
/// along the edge keep half a pitch from other parts. `place`: its pitch is not looked at.
/// Errors: those of PartsOfField, of CutLines, Streamlines and MakePattern.
absl::StatusOr<std::vector<Piece>> PiecesOfField(const MultiPolygon& region, FillPattern pattern,
                                                 const PatternPlace& place,
                                                 const LayerField& field);

}  // namespace slicefarm::infill
