#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/fields/layer_field.h"
#include "services/infill/algo/lines/piece.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Parameters of graded lines.
struct GradedLines {
  double greatest = 1;  ///< density at which each family has all its lines
  /// Smallest length in nm of a piece, unless one of its ends is on the region's boundary. Shorter
  /// gaps in a line are closed too.
  double min_length_nm = 0;
};

/// Returns pieces of families of parallel lines with the local density of the field.
///
/// The families have the pitch of the density `lines.greatest`. Lines have ranks (RankOf): every
/// second line has the lowest rank, every second one of the remaining lines has the next rank, and
/// so on (van der Corput's sequence). A line exists where density / greatest is above its rank.
/// Lines are therefore evenly spaced where the density is greatest / 2^k. Elsewhere their distances
/// differ by a factor of two. The length per area is density / spacing on average over a few lines,
/// and at each point if the families shift from layer to layer.
///
/// Errors and cost: as StraightPieces, and one sample of the field for each 0.25 mm of line.
absl::StatusOr<std::vector<Piece>> GradedPieces(const MultiPolygon& region,
                                                std::span<const LineFamily> families,
                                                const LayerField& field, const GradedLines& lines);

/// Returns the rank of line `index`, in (0, 1): element `index` of van der Corput's sequence 0,
/// 1/2, 1/4, 3/4, 1/8, ..., plus 2^-33. The rank is also the share of lines with a lower rank.
double RankOf(int64_t index);

}  // namespace slicefarm::infill
