#pragma once

#include <cstdint>

#include "common/geometry/point.h"
#include "common/model/raft_heights.h"

namespace slicefarm {

// Options of skirt, brim and raft, which keep parts on the bed. Member comments begin with the
// name of the setting (the name in PrusaSlicer).

/// Use of the skirt as a draught shield. The choice determines the skirt's height and its distance
/// from the parts.
enum class DraftShield : uint8_t {
  kDisabled,  ///< no shield: skirt on the first layers, outside of the brims
  /// Skirt of the usual height, but close to the parts. Where the skirt is, brims are cut off.
  kLimited,
  kEnabled,  ///< skirt close to the parts on all layers
};

/// Start angle below which a loop of the skirt may begin anywhere.
inline constexpr double kNoStartAngle = -6.283;

/// Options of the skirt.
struct SkirtOptions {
  /// Number of skirt loops; 0 disables the skirt and overrides the other options.
  int32_t loops = 0;
  /// `skirt_distance`: distance from the parts to the inner side of the first loop
  Coord distance_nm = 6'000'000;
  double speed_mm_s = 0;      ///< setting skirt_speed; 0: the speed of supports
  Coord min_length_nm = 0;    ///< `min_skirt_length`: minimum length of filament on each layer
  int32_t height_layers = 1;  ///< `skirt_height`: number of layers
  DraftShield draft_shield = DraftShield::kDisabled;  ///< setting draft_shield
  /// `skirt_start_angle`: direction from the middle of the skirt to the start of each loop, from
  /// the x axis; below kNoStartAngle: any start
  double start_angle_rad = -7;
  bool per_object = false;    ///< `skirt_type = perobject`: a skirt around each copy
  bool single_upper = false;  ///< `single_loop_draft_shield`: one loop above the first layer
  Coord width_nm = 400'000;   ///< `first_layer_extrusion_width`: full width of a line
  Coord height_nm = 200'000;  ///< height of the first layer
  /// Cross section of the filament; the default is a diameter of 1.75 mm.
  double filament_area_mm2 = 2.405282;

  friend bool operator==(const SkirtOptions&, const SkirtOptions&) = default;
};

/// Part of an object's outline that gets a brim.
enum class BrimType : uint8_t {
  kNone,
  kOuterOnly,      ///< brim around the object
  kInnerOnly,      ///< brim in the object's holes
  kOuterAndInner,  ///< brim around the object and in its holes
  kEars,           ///< discs at sharp corners of the outer rings only
};

/// `brim_type = auto_brim`, from OrcaSlicer: the brim's width is computed from the object's shape
/// and from these values.
struct AutomaticBrim {
  bool on = false;
  /// Warping length of the material in mm. A shorter length means more warping.
  double thermal_length_mm = 200;
  double adhesion = 1;        ///< factor of the material on the brim's width
  double max_speed_mm_s = 0;  ///< highest print speed of the object

  friend bool operator==(const AutomaticBrim&, const AutomaticBrim&) = default;
};

/// Options of the brim. Brim ears follow OrcaSlicer's rules.
struct BrimOptions {
  BrimType type = BrimType::kNone;  ///< setting brim_type
  AutomaticBrim automatic = {};
  Coord width_nm = 0;       ///< setting brim_width; for ears: their radius
  Coord separation_nm = 0;  ///< setting brim_separation
  /// Width of the brim's lines. Pieces of the brim narrower than half this width are dropped.
  Coord line_width_nm = 400'000;
  double ear_max_angle_rad =
      2.18166;  ///< `brim_ears_max_angle`: largest inner angle of a corner with an ear; 125 degrees
  /// `brim_ears_detection_length`: tolerance to which the outline is simplified before corners are
  /// detected
  Coord ear_detection_nm = 1'000'000;
  bool ears_outside_only = true;  ///< `brim_ears_outer_only`: no ears in holes
  double flow = 1;                ///< `brim_flow_ratio`: factor on the plastic of the brim's lines
  /// `brim_use_efc_outline`: true: the separation begins at the compensated outline of the first
  /// layer; false: at the outline without elefant_foot_compensation
  bool compensated = true;
  Coord foot_nm = 0;  ///< setting elefant_foot_compensation

  friend bool operator==(const BrimOptions&, const BrimOptions&) = default;
};

/// Purpose of a layer of a raft.
enum class RaftLayerKind : uint8_t { kFirst, kBase, kInterface };

/// Returns the kind of a raft layer. `layer`: number of the layer from the bottom, from 0. The
/// upper (layers + 1) / 2 of `layers` layers are kInterface. Below them, layer 0 is kFirst and all
/// other layers are kBase.
constexpr RaftLayerKind RaftLayerKindOf(int32_t layer, int32_t layers) {
  if (layer >= layers / 2) return RaftLayerKind::kInterface;
  return layer == 0 ? RaftLayerKind::kFirst : RaftLayerKind::kBase;
}

/// Lines of a raft's layers, as the settings give them. The region settings of the raft are derived
/// from these values.
struct RaftLines {
  Coord width_nm = 400'000;          ///< setting support_material_extrusion_width
  Coord spacing_nm = 2'500'000;      ///< `support_material_spacing`: gap between lines of the base
  double angle_rad = 0;              ///< setting support_material_angle
  double first_layer_density = 0.9;  ///< setting raft_first_layer_density

  friend bool operator==(const RaftLines&, const RaftLines&) = default;
};

/// Options of the raft.
struct RaftOptions {
  RaftHeights heights = {};
  RaftLines lines = {};
  Coord expansion_nm = 1'500'000;  ///< setting raft_expansion
  /// `raft_first_layer_expansion`: expansion of the first layer, in addition to raft_expansion.
  Coord first_layer_expansion_nm = 3'000'000;

  friend bool operator==(const RaftOptions&, const RaftOptions&) = default;
};

}  // namespace slicefarm
