#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/fields/layer_field.h"
#include "services/infill/algo/lines/piece.h"
#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Pieces of sparse infill inside `area`, which links may follow.
struct FieldPieces {
  MultiPolygon area;
  std::vector<Piece> pieces;
  bool in_cells = false;  ///< the area is made of cells, whose edges lie all over the region
};

/// Fills a region as a field asks for: with streamlines, if it has directions; else with
/// `pattern`, its lines graded if they are straight (GradedPieces), and else, or where the field
/// says so, in dithered cells (DitheredRegion). `place`: its pitch is not looked at.
/// Errors: those of the patterns, of CutLines and Streamlines.
absl::StatusOr<FieldPieces> PiecesOfField(const MultiPolygon& region, FillPattern pattern,
                                          const PatternPlace& place, const LayerField& field);

}  // namespace slicefarm::infill
