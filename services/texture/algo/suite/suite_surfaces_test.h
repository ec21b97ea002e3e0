#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture {

struct NamedSurface {
  std::string name;
  SurfaceMesh mesh;
};

/// Returns a surface of n x n squares over x and y of 0 to 30 mm, with the height that `height`
/// returns.
inline SurfaceMesh HeightField(int n, const std::function<double(double, double)>& height) {
  return GridSurface(n, [=](double x, double y) {
    return Eigen::Vector3d(30 * x, 30 * y, height(30 * x, 30 * y));
  });
}

/// Returns a strip of a torus' outside or inside. `from` and `to` are the tube's angles divided by
/// pi.
inline SurfaceMesh TubePart(int n, double from, double to, double turn) {
  return GridSurface(n, [=](double x, double y) {
    const double b = std::numbers::pi * (from + (to - from) * y), a = std::numbers::pi * turn * x;
    const double out = 20 + 8 * std::cos(b);
    return Eigen::Vector3d(out * std::cos(a), out * std::sin(a), 8 * std::sin(b));
  });
}

/// Returns a part of a cone or a cylinder around z.
inline SurfaceMesh TurnedPart(int n, double low_mm, double high_mm, double turn) {
  return GridSurface(n, [=](double x, double y) {
    const double a = std::numbers::pi * turn * x, r = low_mm + (high_mm - low_mm) * y;
    return Eigen::Vector3d(r * std::cos(a), r * std::sin(a), 24 * y);
  });
}

/// Returns a shell swept along a helix, like the guard of a hand.
inline SurfaceMesh SweptShell(int n, double bend, double rise) {
  return GridSurface(n, [=](double x, double y) {
    const double a = std::numbers::pi * bend * x, b = std::numbers::pi * (0.1 + 0.8 * y);
    const double out = 18 + 6 * std::sin(b) * (1 + 0.3 * std::sin(2 * a));
    return Eigen::Vector3d(out * std::cos(a), out * std::sin(a), -12 * std::cos(b) + rise * x);
  });
}

inline SurfaceMesh Scaled(SurfaceMesh mesh, double factor) {
  for (Eigen::Vector3d& p : mesh.points_mm) p *= factor;
  return mesh;
}

/// Returns twenty surfaces of disk topology, some with holes: height fields, parts of tori,
/// cylinders and cones, caps, swept shells.
inline std::vector<NamedSurface> SuiteSurfaces() {
  const auto round_hole = [](const Eigen::Vector3d& p) {
    return std::hypot(p.x() - 14, p.y() - 16) < 5;
  };
  return {
      {"flat", HeightField(12, [](double, double) { return 0.0; })},
      {"two triangles", HeightField(1, [](double, double) { return 0.0; })},
      {"flat with a hole",
       Without(HeightField(20, [](double, double) { return 0.0; }), round_hole)},
      {"waves",
       HeightField(24, [](double x, double y) { return 2 * std::sin(x / 5) * std::cos(y / 6); })},
      {"saddle", HeightField(16, [](double x, double y) { return (x - 15) * (y - 15) / 20; })},
      {"bowl",
       HeightField(16, [](double x,
                          double y) { return ((x - 15) * (x - 15) + (y - 15) * (y - 15)) / 30; })},
      {"dome with a hole",
       Without(HeightField(22,
                           [](double x, double y) {
                             return -((x - 15) * (x - 15) + (y - 15) * (y - 15)) / 40;
                           }),
               round_hole)},
      {"ramp", HeightField(9, [](double x, double y) { return 0.8 * x + 0.3 * y; })},
      {"roof", HeightField(14, [](double x, double) { return -0.4 * std::abs(x - 15); })},
      {"outer half torus", TubePart(20, -0.5, 0.5, 1)},
      {"inner half torus", TubePart(20, 0.6, 1.4, 1)},
      {"three quarters of a tube", TubePart(20, -0.7, 0.7, 1.5)},
      {"half cylinder", TurnedPart(16, 10, 10, 1)},
      {"cut cylinder", TurnedPart(24, 9, 9, 1.9)},
      {"cone", TurnedPart(18, 16, 6, 1.2)},
      {"cap", Scaled(Cap(16, 0.4), 18)},
      {"half sphere", Scaled(Cap(18, 0), 14)},
      {"most of a sphere", Scaled(Cap(22, -0.7), 10)},
      {"swept shell", SweptShell(20, 0.8, 6)},
      {"long swept shell", SweptShell(26, 1.4, 18)},
  };
}

}  // namespace slicefarm::texture
