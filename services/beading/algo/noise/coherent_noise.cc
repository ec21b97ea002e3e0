#include "services/beading/algo/noise/coherent_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/base/split_mix.h"

namespace slicefarm::beading {
namespace {

/// Cube of the noise's lattice.
struct LatticeCube {
  int64_t x = 0, y = 0, z = 0;
};

/// Returns well-mixed bits for a corner of the lattice.
uint64_t CornerBits(const LatticeCube& cube, uint64_t seed) {
  uint64_t bits = seed;
  for (const int64_t part : {cube.x, cube.y, cube.z})
    bits = MixedBits((bits ^ static_cast<uint64_t>(part)) + kSplitMixStep);
  return bits;
}

/// Returns the height of a corner's slope at a point, given relative to the corner. The gradient is
/// one of the twelve directions to the edges of a cube.
double CornerSlope(uint64_t bits, double x, double y, double z) {
  const uint64_t edge = bits % 12;
  const double first = edge < 8 ? x : y;
  const double second = edge < 4 ? y : z;
  return (edge % 2 == 0 ? first : -first) + (edge % 4 < 2 ? second : -second);
}

double SmoothStep5(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

double Mixed(double a, double b, double share) { return a + share * (b - a); }

LatticeCube CubeOf(const Vector3& at) {
  return {static_cast<int64_t>(std::floor(at.x())), static_cast<int64_t>(std::floor(at.y())),
          static_cast<int64_t>(std::floor(at.z()))};
}

}  // namespace

double GradientNoise(const Vector3& at, uint64_t seed) {
  const LatticeCube cube = CubeOf(at);
  const double x = at.x() - static_cast<double>(cube.x), y = at.y() - static_cast<double>(cube.y),
               z = at.z() - static_cast<double>(cube.z);
  std::array<double, 8> corners{};
  for (int i = 0; i < 8; ++i) {
    const int dx = i & 1, dy = i >> 1 & 1, dz = i >> 2;
    corners[static_cast<size_t>(i)] = CornerSlope(
        CornerBits({cube.x + dx, cube.y + dy, cube.z + dz}, seed), x - dx, y - dy, z - dz);
  }
  const double u = SmoothStep5(x), v = SmoothStep5(y), w = SmoothStep5(z);
  const double low = Mixed(Mixed(corners[0], corners[1], u), Mixed(corners[2], corners[3], u), v);
  const double high = Mixed(Mixed(corners[4], corners[5], u), Mixed(corners[6], corners[7], u), v);
  return std::clamp(Mixed(low, high, w), -1.0, 1.0);
}

double PerlinNoise(const Vector3& at, const Octaves& octaves) {
  double sum = 0, share = 1, size = 1;
  for (int32_t i = 0; i < octaves.count; ++i, share *= octaves.persistence, size *= 2)
    sum += share * GradientNoise(at * size, static_cast<uint64_t>(i));
  return std::clamp(sum, -1.0, 1.0);
}

double BillowNoise(const Vector3& at, const Octaves& octaves) {
  double sum = 0.5, share = 1, size = 1;
  for (int32_t i = 0; i < octaves.count; ++i, share *= octaves.persistence, size *= 2)
    sum += share * (2 * std::abs(GradientNoise(at * size, static_cast<uint64_t>(i))) - 1);
  return std::clamp(sum, -1.0, 1.0);
}

double RidgedNoise(const Vector3& at, int32_t octaves) {
  double sum = 0, weight = 1, size = 1;
  for (int32_t i = 0; i < octaves; ++i, size *= 2) {
    const double ridge = 1 - std::abs(GradientNoise(at * size, static_cast<uint64_t>(i)));
    const double signal = ridge * ridge * weight;
    weight = std::min(1.0, 2 * signal);
    sum += signal / size;
  }
  return std::clamp(1.25 * sum - 1, -1.0, 1.0);
}

double VoronoiNoise(const Vector3& at) {
  constexpr int64_t kReach = 2;  // a nearer centre may be two cubes away
  const LatticeCube cube = CubeOf(at);
  double nearest = std::numeric_limits<double>::infinity(), value = 0;
  for (int64_t x = cube.x - kReach; x <= cube.x + kReach; ++x)
    for (int64_t y = cube.y - kReach; y <= cube.y + kReach; ++y)
      for (int64_t z = cube.z - kReach; z <= cube.z + kReach; ++z) {
        const LatticeCube other{x, y, z};
        const double dx = static_cast<double>(x) + ShareOfBits(CornerBits(other, 1)) - at.x();
        const double dy = static_cast<double>(y) + ShareOfBits(CornerBits(other, 2)) - at.y();
        const double dz = static_cast<double>(z) + ShareOfBits(CornerBits(other, 3)) - at.z();
        const double distance = dx * dx + dy * dy + dz * dz;
        if (distance >= nearest) continue;
        nearest = distance;
        value = 2 * ShareOfBits(CornerBits(other, 4)) - 1;
      }
  return value;
}

}  // namespace slicefarm::beading
