#pragma once

#include <cstdint>

#include "common/geometry/point.h"
#include "common/model/raft_heights.h"

namespace slicefarm {

/// What keeps parts on the bed. Names in the comments are the settings' (PrusaSlicer's).

/// How far up a skirt stands as a wall against draft, and what it keeps its distance from.
enum class DraftShield : uint8_t {
  kDisabled,  ///< a skirt on the first layers, outside of the brims
  kLimited,   ///< as high as a skirt, but close to the parts: brims give way to it
  kEnabled,   ///< the same on all layers
};

struct SkirtOptions {
  int32_t loops = 0;              ///< skirts; 0: none, whatever else is asked for
  Coord distance_nm = 6'000'000;  ///< skirt_distance: to the inner edge of the first line
  Coord min_length_nm = 0;        ///< min_skirt_length: of filament, on one layer
  int32_t height_layers = 1;      ///< skirt_height
  DraftShield draft_shield = DraftShield::kDisabled;  ///< draft_shield
  Coord width_nm = 400'000;             ///< of a line over all: first_layer_extrusion_width
  Coord height_nm = 200'000;            ///< of the first layer
  double filament_area_mm2 = 2.405282;  ///< section of the filament: 1.75 mm across

  friend bool operator==(const SkirtOptions&, const SkirtOptions&) = default;
};

enum class BrimType : uint8_t {
  kNone,
  kOuterOnly,      ///< around the object
  kInnerOnly,      ///< in its holes
  kOuterAndInner,  ///< both
  kEars,           ///< discs at sharp corners of the outer rings only
};

/// brim_type = auto_brim, OrcaSlicer's: the width follows from the object's shape and these.
struct AutomaticBrim {
  bool on = false;
  double thermal_length_mm = 200;  ///< of the material: shorter ones warp more
  double adhesion = 1;             ///< of the material: brims are so many times as wide
  double max_speed_mm_s = 0;       ///< of what is printed

  friend bool operator==(const AutomaticBrim&, const AutomaticBrim&) = default;
};

/// Ears are OrcaSlicer's.
struct BrimOptions {
  BrimType type = BrimType::kNone;  ///< brim_type
  AutomaticBrim automatic = {};
  Coord width_nm = 0;             ///< brim_width; of ears: their radius
  Coord separation_nm = 0;        ///< brim_separation
  Coord line_width_nm = 400'000;  ///< of the brim's lines; below half of it nothing is left
  double ear_max_angle_rad =
      2.18166;  ///< brim_ears_max_angle: inner angle of a corner, 125 degrees
  Coord ear_detection_nm = 1'000'000;  ///< brim_ears_detection_length: corners are those of the
                                       ///< outline simplified to this

  friend bool operator==(const BrimOptions&, const BrimOptions&) = default;
};

/// What a layer of a raft is for.
enum class RaftLayerKind : uint8_t { kFirst, kBase, kInterface };

/// Of n layers the upper (n + 1) / 2 are interface; of those below, the lowest one is the first.
constexpr RaftLayerKind RaftLayerKindOf(int32_t layer, int32_t layers) {
  if (layer >= layers / 2) return RaftLayerKind::kInterface;
  return layer == 0 ? RaftLayerKind::kFirst : RaftLayerKind::kBase;
}

/// The lines of a raft's layers, as the settings say: rows of region settings are made of it.
struct RaftLines {
  Coord width_nm = 400'000;          ///< support_material_extrusion_width
  Coord spacing_nm = 2'500'000;      ///< support_material_spacing: free between lines of the base
  double angle_rad = 0;              ///< support_material_angle
  double first_layer_density = 0.9;  ///< raft_first_layer_density

  friend bool operator==(const RaftLines&, const RaftLines&) = default;
};

struct RaftOptions {
  RaftHeights heights = {};
  RaftLines lines = {};
  Coord expansion_nm = 1'500'000;              ///< raft_expansion
  Coord first_layer_expansion_nm = 3'000'000;  ///< raft_first_layer_expansion, beyond the former

  friend bool operator==(const RaftOptions&, const RaftOptions&) = default;
};

}  // namespace slicefarm
