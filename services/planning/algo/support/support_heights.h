#pragma once

#include <vector>

#include "services/planning/algo/support/overhangs.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm {
struct SupportOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

struct SupportHeight {
  Coord bottom_nm = 0;
  Coord top_nm = 0;

  friend bool operator==(const SupportHeight&, const SupportHeight&) = default;
};

/// The layers of support, upwards from the bed without gaps, and which of them each overhang lies
/// on.
struct SupportHeights {
  std::vector<SupportHeight> layers;
  std::vector<int32_t> under;  ///< by layer of the part; -1: no overhang, or no room under it

  friend bool operator==(const SupportHeights&, const SupportHeights&) = default;
};

/// Layers with a top top_gap_nm below each layer of the part that hangs over. Tops that
/// are nearer than min_layer_height_nm to each other become the lower one. Between them layers are
/// as high as can be up to layer_height_nm, or a tenth more where that is the top of a layer of the
/// part; the first one is first_layer_height_nm, as the part's own.
/// Layers of branches end where the part's do: between contacts always, and below a contact if that
/// takes no more than half a layer_height_nm from its top.
/// With synchronize_layers tops are those of the part's layers, the next below what they carry.
/// Overhangs so low that the first layer does not fit under them have none: the bed is near.
SupportHeights HeightsFor(const SupportProblem& problem, const std::vector<Overhang>& overhangs,
                          const SupportOptions& options);

}  // namespace slicefarm::planning
