#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/fields/layer_field.h"
#include "services/infill/algo/lines/piece.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

struct GradedLines {
  double greatest = 1;  ///< density of the families with all their lines
  double min_length_nm = 0;  ///< stretches of a line shorter than this neither begin nor end there
};

/// Pieces of families of parallel lines that are as dense as the field asks for at each place.
///
/// The families have the pitch of the field's greatest density. Lines have ranks: every second one
/// is of the lowest, of those that remain every second one of the next, and so on (van der
/// Corput's sequence), and a line is there where density / greatest is above its rank. So lines
/// lie evenly wherever the density is greatest / 2^k, at distances that differ by a factor of two
/// elsewhere, and length per area is density / spacing on average over few lines. If the families
/// move aside from layer to layer, it is so at each place.
///
/// Errors and cost: as StraightPieces, and a look at the field for each kLookMm of line.
absl::StatusOr<std::vector<Piece>> GradedPieces(const MultiPolygon& region,
                                                std::span<const LineFamily> families,
                                                const LayerField& field, const GradedLines& lines);

/// The share of lines whose rank lies below that of line `index`: in (0, 1), each binary fraction
/// once before it is halved again.
double RankOf(int64_t index);

}  // namespace slicefarm::infill
