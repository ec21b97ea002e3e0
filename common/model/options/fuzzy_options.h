#pragma once

#include <cstdint>

namespace slicefarm {

/// `fuzzy_skin_mode`: change of a wall that makes its surface rough.
enum class FuzzyMode : uint8_t {
  kDisplacement,  ///< points move inwards and outwards
  kExtrusion,     ///< beads become wider and narrower
  kCombined,      ///< beads become wider and narrower on their outer side only
};

/// `fuzzy_skin_noise_type`: function that decides how far each point moves.
enum class FuzzyNoise : uint8_t {
  kClassic,      ///< random numbers that do not depend on each other
  kPerlin,       ///< smooth hills and valleys
  kBillow,       ///< rounded lumps
  kRidgedMulti,  ///< sharp ridges
  kVoronoi,      ///< cells with steps between them
  kRipple,       ///< waves along the wall
};

/// Texture of fuzzy walls. Member comments begin with the name of the setting.
struct FuzzyTexture {
  FuzzyMode mode = FuzzyMode::kDisplacement;  ///< setting fuzzy_skin_mode
  FuzzyNoise noise = FuzzyNoise::kClassic;    ///< setting fuzzy_skin_noise_type
  double scale_mm = 1;        ///< `fuzzy_skin_scale`: size of the noise's largest features
  int32_t octaves = 4;        ///< `fuzzy_skin_octaves`: number of sizes that are added
  double persistence = 0.5;   ///< `fuzzy_skin_persistence`: share of each next smaller size
  bool first_layer = false;   ///< setting fuzzy_skin_first_layer
  int32_t ripples = 15;       ///< `fuzzy_skin_ripples_per_layer`: number of waves around a wall
  double ripple_shift = 0.5;  ///< `fuzzy_skin_ripple_offset`: shift of waves, in wavelengths
  /// `fuzzy_skin_layers_between_ripple_offset`: number of layers with equal waves
  int32_t ripple_layers = 1;

  friend bool operator==(const FuzzyTexture&, const FuzzyTexture&) = default;
};

}  // namespace slicefarm
