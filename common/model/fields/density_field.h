#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/fields/field_grid.h"

namespace slicefarm {

/// Formula that converts a field's value v in [0, 1] to a density in [0, 1].
enum class DensityLaw : uint8_t {
  kLinear,
  kSimp,       ///< v^p
  kRamp,       ///< v / (1 + q (1 - v))
  kHeaviside,  ///< (tanh(b e) + tanh(b (v - e))) / (tanh(b e) + tanh(b (1 - e)))
};

/// Method of dithering: each cell of the infill is either empty or filled with the field's greatest
/// density, and the method selects the filled cells.
enum class Dither : uint8_t {
  /// No dithering: the line spacing follows the field. For patterns with a fixed spacing,
  /// kBlueNoise is used.
  kNone,
  kBlueNoise,
  kFloydSteinberg,
};

/// Density of the sparse infill as a function of position: of the height, the distance to the
/// part's surface, or all three coordinates.
struct DensityField {
  enum class Kind : uint8_t { kHeight, kSurfaceDistance, kGrid };

  Kind kind = Kind::kHeight;
  /// heights above the object's bottom, or distances to the surface, ascending
  std::vector<double> at_mm = {0};
  /// Values at `at_mm`: linear in between, constant beyond both ends.
  std::vector<double> values = {0.2};
  FieldGrid grid = {};  ///< grid of a field of kind kGrid
  DensityLaw law = DensityLaw::kLinear;
  double steepness = 3;    ///< parameter p, q or b of the formula
  double threshold = 0.5;  ///< parameter e of the formula
  Dither dither = Dither::kNone;
  double cell_mm = 2;  ///< side length of a dither cell

  double At(const PositionMm& position_mm, double to_surface_mm) const;
  /// Returns the density of the layer at height z if it is the same in the whole layer, otherwise
  /// nullopt.
  std::optional<double> UniformAt(double z_mm) const;
  double Greatest() const;
  double Least() const;
  /// Returns the largest distance to the surface that influences the density, in mm. Returns 0 if
  /// the distance has no influence.
  double ReachMm() const;

  friend bool operator==(const DensityField&, const DensityField&) = default;
};

/// Returns the density for one field value by the formula `law`. `steepness`, `threshold`:
/// parameters of the formula as in DensityField. REQUIRES: value in [0, 1], steepness > 0.
double DensityOf(double value, DensityLaw law, double steepness, double threshold);

}  // namespace slicefarm
