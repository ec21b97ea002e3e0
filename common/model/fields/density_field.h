#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/fields/field_grid.h"

namespace slicefarm {

/// How a field's value v in [0, 1] becomes a density in [0, 1].
enum class DensityLaw : uint8_t {
  kLinear,
  kSimp,       ///< v^p
  kRamp,       ///< v / (1 + q (1 - v))
  kHeaviside,  ///< (tanh(b e) + tanh(b (v - e))) / (tanh(b e) + tanh(b (1 - e)))
};

/// How cells are chosen that are filled as densely as the field gets anywhere, or not at all.
enum class Dither : uint8_t {
  kNone,  ///< lines are graded; blue noise for patterns whose lines cannot be
  kBlueNoise,
  kFloydSteinberg,
};

/// How dense the sparse infill is, by place. A pure function of the place and of its distance to
/// the part's surface.
struct DensityField {
  enum class Kind : uint8_t { kHeight, kSurfaceDistance, kGrid };

  Kind kind = Kind::kHeight;
  std::vector<double> at_mm = {0};  ///< heights or distances, ascending
  std::vector<double> values = {0.2};  ///< at them; linear between, as at the ends beyond
  FieldGrid grid = {};                 ///< of kGrid
  DensityLaw law = DensityLaw::kLinear;
  double steepness = 3;  ///< p, q or b of the law
  double threshold = 0.5;  ///< e
  Dither dither = Dither::kNone;
  double cell_mm = 2;  ///< side of a cell that is dithered

  double At(const PlaceMm& place_mm, double to_surface_mm) const;
  /// The density of a whole layer, if it is the same everywhere.
  std::optional<double> UniformAt(double z_mm) const;
  double Greatest() const;
  double Least() const;
  /// How far away the surface still counts, mm; 0: not at all.
  double ReachMm() const;

  friend bool operator==(const DensityField&, const DensityField&) = default;
};

/// The law alone. REQUIRES: value in [0, 1], steepness > 0.
double DensityOf(double value, DensityLaw law, double steepness, double threshold);

}  // namespace slicefarm
