#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// A grid of n x n squares over [0, 1]^2, each point moved to where `place` says.
inline SurfaceMesh GridSurface(int n, const std::function<Eigen::Vector3d(double, double)>& place) {
  SurfaceMesh mesh;
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x)
      mesh.points_mm.push_back(place(static_cast<double>(x) / n, static_cast<double>(y) / n));
  }
  const auto at = [n](int x, int y) { return y * (n + 1) + x; };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      mesh.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return mesh;
}

inline SurfaceMesh FlatSquare(int n, double side_mm) {
  return GridSurface(
      n, [=](double x, double y) { return Eigen::Vector3d(side_mm * x, side_mm * y, 0); });
}

/// Half a cylinder: can be laid flat without distortion.
inline SurfaceMesh HalfCylinder(int n, double radius_mm, double height_mm) {
  return GridSurface(n, [=](double x, double y) {
    const double angle = std::numbers::pi * x;
    return Eigen::Vector3d(-radius_mm * std::cos(angle), height_mm * y,
                           radius_mm * std::sin(angle));
  });
}

/// A sphere of radius 1 without what lies below `lowest`: the nearer to -1, the longer its neck.
inline SurfaceMesh Cap(int n, double lowest) {
  return GridSurface(n, [=](double x, double y) {
    const double u = 2 * x - 1, v = 2 * y - 1;
    const double radius = std::max(std::abs(u), std::abs(v));
    const double norm = std::hypot(u, v);
    const double polar = radius * std::acos(lowest);
    if (norm == 0) return Eigen::Vector3d(0, 0, 1);
    return Eigen::Vector3d(std::sin(polar) * u / norm, std::sin(polar) * v / norm, std::cos(polar));
  });
}

/// Without the triangles that `drop` wants gone.
inline SurfaceMesh Without(SurfaceMesh mesh,
                           const std::function<bool(const Eigen::Vector3d&)>& drop) {
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return drop((mesh.points_mm[t[0]] + mesh.points_mm[t[1]] + mesh.points_mm[t[2]]) / 3);
  });
  return mesh;
}

}  // namespace slicefarm::texture
