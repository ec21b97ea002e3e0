#include "services/beading/algo/noise/skin_noise.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "services/beading/algo/noise/coherent_noise.h"

namespace slicefarm::beading {
namespace {

/// Returns the distance along a closed wall at which it crosses the x axis furthest to the left.
/// For a wall that does not cross the axis, returns the distance of the corner nearest to the axis.
double AnchorOf(const Path& wall) {
  double along = 0, crossing = -1, corner = 0;
  double left = std::numeric_limits<double>::infinity();
  Coord nearest = std::numeric_limits<Coord>::max();
  const size_t count = wall.points.size();
  for (size_t i = 0; i < count; ++i) {
    const Point a = wall.points[i], b = wall.points[(i + 1) % count];
    const double length = Distance(a, b);
    if (std::abs(a.y) < nearest) {
      nearest = std::abs(a.y);
      corner = along;
    }
    if ((a.y <= 0) != (b.y <= 0)) {
      const double share = static_cast<double>(a.y) / static_cast<double>(a.y - b.y);
      const double x = static_cast<double>(a.x) + share * static_cast<double>(b.x - a.x);
      if (x < left) {
        left = x;
        crossing = along + share * length;
      }
    }
    along += length;
  }
  return crossing >= 0 ? crossing : corner;
}

}  // namespace

double TextureNoise(const FuzzyTexture& texture, Point at, Coord z_nm) {
  const auto scaled = [&](Coord nm) { return ToMm(nm) / texture.scale_mm; };
  const Vector3 place{scaled(at.x), scaled(at.y), scaled(z_nm)};
  const Octaves octaves{texture.octaves, texture.persistence};
  switch (texture.noise) {
    case FuzzyNoise::kPerlin:
      return PerlinNoise(place, octaves);
    case FuzzyNoise::kBillow:
      return BillowNoise(place, octaves);
    case FuzzyNoise::kRidgedMulti:
      return RidgedNoise(place, texture.octaves);
    case FuzzyNoise::kVoronoi:
      return VoronoiNoise(place);
    case FuzzyNoise::kClassic:
    case FuzzyNoise::kRipple:
      break;
  }
  return 0;
}

Ripples::Ripples(const FuzzyTexture& texture, const Path& wall, int32_t layer)
    : waves_per_nm_(texture.ripples / std::max(1.0, Perimeter(wall.points))),
      crest_nm_(AnchorOf(wall)) {
  const double shift = layer / std::max(1, texture.ripple_layers) * texture.ripple_shift;
  shift_ = shift - std::floor(shift);
}

double Ripples::At(double along_nm) const {
  const double waves = (along_nm - crest_nm_) * waves_per_nm_ + shift_;
  return Cos(2 * std::numbers::pi * (waves - std::floor(waves)));
}

}  // namespace slicefarm::beading
