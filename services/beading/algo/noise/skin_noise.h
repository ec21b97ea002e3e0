#pragma once

#include "common/geometry/point.h"
#include "common/model/options/fuzzy_options.h"
#include "common/model/path.h"

namespace slicefarm::beading {

/// Returns the noise of a texture at a point of a layer, in [-1, 1]. REQUIRES: the noise depends on
/// the position: it is neither kClassic nor kRipple.
double TextureNoise(const FuzzyTexture& texture, Point at, Coord z_nm);

/// Waves along a closed wall: a whole number of equal waves. The first crest is where the wall
/// crosses the x axis of the object furthest to the left, or at the corner nearest to the axis. So
/// waves of consecutive layers fit each other.
class Ripples {
 public:
  /// `layer`: index of the layer, which decides the shift of the waves.
  Ripples(const FuzzyTexture& texture, const Path& wall, int32_t layer);

  /// Returns the height of the waves at a distance along the wall from its first point, in [-1, 1].
  double At(double along_nm) const;

 private:
  double waves_per_nm_ = 0;
  double crest_nm_ = 0;  ///< distance of the first crest from the wall's first point
  double shift_ = 0;     ///< shift of the waves, in wavelengths
};

}  // namespace slicefarm::beading
