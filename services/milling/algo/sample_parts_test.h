#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string_view>
#include <vector>

#include "common/geometry/measure.h"
#include "common/model/options/sample_cutters_test.h"
#include "services/milling/algo/mesh/triangle_mesh.h"

namespace slicefarm::milling {

inline void AddQuad(TriangleMesh& mesh, const std::array<Eigen::Vector3d, 4>& corners) {
  const auto first = static_cast<uint32_t>(mesh.points_mm.size());
  mesh.points_mm.insert(mesh.points_mm.end(), corners.begin(), corners.end());
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

inline void Append(TriangleMesh& mesh, const TriangleMesh& other) {
  const auto first = static_cast<uint32_t>(mesh.points_mm.size());
  mesh.points_mm.insert(mesh.points_mm.end(), other.points_mm.begin(), other.points_mm.end());
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

/// Returns a box without a bottom: four walls and a top.
inline TriangleMesh Box(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  TriangleMesh mesh;
  mesh.points_mm = {{a.x(), a.y(), a.z()}, {b.x(), a.y(), a.z()}, {b.x(), b.y(), a.z()},
                    {a.x(), b.y(), a.z()}, {a.x(), a.y(), b.z()}, {b.x(), a.y(), b.z()},
                    {b.x(), b.y(), b.z()}, {a.x(), b.y(), b.z()}};
  for (uint32_t k = 0; k < 4; ++k) {
    const uint32_t n = (k + 1) % 4;
    mesh.triangles.push_back({k, n, n + 4});
    mesh.triangles.push_back({k, n + 4, k + 4});
  }
  mesh.triangles.push_back({4, 5, 6});
  mesh.triangles.push_back({4, 6, 7});
  return mesh;
}

/// Returns a sphere around the origin, with its corners on the exact sphere.
inline TriangleMesh Sphere(double radius, uint32_t around = 48) {
  TriangleMesh mesh;
  const uint32_t rows = around / 2;
  for (uint32_t row = 0; row <= rows; ++row) {
    for (uint32_t k = 0; k < around; ++k) {
      const double a = std::numbers::pi * row / rows, b = 2 * std::numbers::pi * k / around;
      mesh.points_mm.push_back({radius * std::sin(a) * std::cos(b),
                                radius * std::sin(a) * std::sin(b), radius * std::cos(a)});
    }
  }
  for (uint32_t row = 0; row < rows; ++row) {
    for (uint32_t k = 0; k < around; ++k) {
      const uint32_t a = row * around + k, b = row * around + (k + 1) % around;
      mesh.triangles.push_back({a, a + around, b + around});
      mesh.triangles.push_back({a, b + around, b});
    }
  }
  return mesh;
}

/// Returns waves over a square of side `size`, with heights from -1 to 1.
inline TriangleMesh Waves(double size, uint32_t cells) {
  TriangleMesh mesh;
  for (uint32_t row = 0; row <= cells; ++row) {
    for (uint32_t k = 0; k <= cells; ++k) {
      const double x = size * k / cells, y = size * row / cells;
      mesh.points_mm.push_back({x, y, std::sin(1.3 * x) * std::cos(0.9 * y + 0.4 * x)});
    }
  }
  for (uint32_t row = 0; row < cells; ++row) {
    for (uint32_t k = 0; k < cells; ++k) {
      const uint32_t a = row * (cells + 1) + k;
      mesh.triangles.push_back({a, a + 1, a + cells + 2});
      mesh.triangles.push_back({a, a + cells + 2, a + cells + 1});
    }
  }
  return mesh;
}

inline TriangleMesh RandomTriangle(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> any(-size, size);
  TriangleMesh mesh;
  for (int k = 0; k < 3; ++k) mesh.points_mm.push_back({any(random), any(random), any(random)});
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// Returns the horizontal distance between the cutter with this tip position and a dense sample of
/// the mesh; a negative value means a gouge. The mesh itself may be closer than its sample.
/// Infinite if nothing is above the tip's height.
inline double SampledClearance(const TriangleMesh& mesh, const Cutter& cutter,
                               const Eigen::Vector3d& tip, int samples = 100) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d &o = mesh.points_mm[t[0]], u = mesh.points_mm[t[1]] - o,
                          v = mesh.points_mm[t[2]] - o;
    for (int i = 0; i <= samples; ++i) {
      for (int k = 0; i + k <= samples; ++k) {
        const Eigen::Vector3d q = o + u * (static_cast<double>(i) / samples) +
                                  v * (static_cast<double>(k) / samples) - tip;
        if (q.z() > 1e-9) least = std::min(least, q.head<2>().norm() - cutter.Width(q.z()));
      }
    }
  }
  return least;
}

}  // namespace slicefarm::milling
