#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

/// How high the layers of a raft are, and what stands on it.
struct RaftHeights {
  int32_t layers = 0;                   ///< raft_layers; 0: no raft
  Coord first_nm = 200'000;             ///< first_layer_height: the raft's, no longer the part's
  Coord others_nm = 300'000;            ///< the greater of layer_height and 3/4 of nozzle_diameter
  Coord contact_distance_nm = 100'000;  ///< raft_contact_distance: from the raft's top to the part

  Coord HeightOf(int32_t layer) const { return layer == 0 ? first_nm : others_nm; }
  /// The top of a layer, above the bed.
  Coord TopOf(int32_t layer) const { return first_nm + layer * others_nm; }
  /// The part's bottom, above the bed; 0 without a raft.
  Coord LiftNm() const { return layers > 0 ? TopOf(layers - 1) + contact_distance_nm : 0; }

  friend bool operator==(const RaftHeights&, const RaftHeights&) = default;
};

}  // namespace slicefarm
