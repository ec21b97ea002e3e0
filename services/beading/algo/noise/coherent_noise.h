#pragma once

#include <cstdint>

#include "common/geometry/vector.h"

namespace slicefarm::beading {

/// Returns gradient noise in [-1, 1], with features of the size 1. It is smooth, and 0 at all
/// points with whole coordinates. The same arguments give the same value on all machines. Source:
/// K. Perlin, "Improving Noise", SIGGRAPH 2002, with hashed numbers in place of a table.
double GradientNoise(const Vector3& at, uint64_t seed);

/// Noises that are added. The features of each octave are half as large as the previous octave's
/// features.
struct Octaves {
  int32_t count = 1;
  double persistence = 0.5;  ///< ratio of an octave's height to the previous octave's height
};

// Sums of GradientNoise over octaves, within [-1, 1].

/// Returns smooth hills and valleys (Perlin noise).
double PerlinNoise(const Vector3& at, const Octaves& octaves);
/// Returns rounded lumps: the magnitude of each octave.
double BillowNoise(const Vector3& at, const Octaves& octaves);
/// Returns sharp ridges: the inverted magnitude of each octave, weighted by the previous octave, so
/// that valleys remain smooth. Source: F. K. Musgrave, "Texturing and Modeling: A Procedural
/// Approach", ridged multifractal.
double RidgedNoise(const Vector3& at, int32_t octaves);

/// Returns a random value in [-1, 1] for each cell of a Voronoi diagram, with one centre at a
/// random position in each unit cube.
double VoronoiNoise(const Vector3& at);

}  // namespace slicefarm::beading
