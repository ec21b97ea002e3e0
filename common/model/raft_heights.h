#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

/// Heights of a raft's layers and of the part on it.
struct RaftHeights {
  int32_t layers = 0;  ///< `raft_layers`: number of layers; 0: no raft
  /// `first_layer_height`: height of the raft's first layer. With a raft, the part's own first
  /// layer does not have this height.
  Coord first_nm = 200'000;
  /// Height of the raft's other layers: the greater of layer_height and 3/4 of nozzle_diameter.
  Coord others_nm = 300'000;
  /// `raft_contact_distance`: gap between the raft's top and the part
  Coord contact_distance_nm = 100'000;

  Coord HeightOf(int32_t layer) const { return layer == 0 ? first_nm : others_nm; }
  /// Returns the height of a layer's top above the bed.
  Coord TopOf(int32_t layer) const { return first_nm + layer * others_nm; }
  /// Returns the height of the part's bottom above the bed; 0 without a raft.
  Coord LiftNm() const { return layers > 0 ? TopOf(layers - 1) + contact_distance_nm : 0; }

  friend bool operator==(const RaftHeights&, const RaftHeights&) = default;
};

}  // namespace slicefarm
