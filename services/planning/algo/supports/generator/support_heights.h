#pragma once

#include <vector>

#include "services/planning/algo/supports/generator/overhangs.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Bottom and top of one layer of support, above the bed.
struct SupportHeight {
  Coord bottom_nm = 0;
  Coord top_nm = 0;

  friend bool operator==(const SupportHeight&, const SupportHeight&) = default;
};

/// Heights of the layers of support, and the layer of support under each overhang.
struct SupportHeights {
  std::vector<SupportHeight> layers;
  /// Index of the highest layer of support under each layer of the part; -1 if the layer has no
  /// overhang, or if there is no space under it.
  std::vector<int32_t> under;

  friend bool operator==(const SupportHeights&, const SupportHeights&) = default;
};

/// Computes the heights of the layers of support. Each overhanging layer of the part wants a top: a
/// layer of support that ends top_gap_nm below the overhang.
/// - Of tops closer to each other than min_layer_height_nm only the lower one is used.
/// - Layers between tops are as high as possible, up to layer_height_nm. They may be a tenth higher
///   to end at the top of a layer of the part. The first layer is first_layer_height_nm high, like
///   the part's own.
/// - With branches, layers that are not below a contact end with layers of the part. A layer below
///   a contact also ends there, if this moves its top down by no more than half a layer_height_nm.
/// - With synchronize_layers all tops are tops of the part's layers: the next top below the
///   overhang.
/// - Overhangs too low for the first layer get no support, because the bed is near.
SupportHeights HeightsFor(const SupportProblem& problem, const std::vector<Overhang>& overhangs,
                          const SupportOptions& options);

}  // namespace slicefarm::planning
