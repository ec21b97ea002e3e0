#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Returns a grid of n x n squares over [0, 1]^2, with each point moved to the position that
/// `place` returns.
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

/// Returns a half cylinder, which can be laid flat without distortion.
inline SurfaceMesh HalfCylinder(int n, double radius_mm, double height_mm) {
  return GridSurface(n, [=](double x, double y) {
    const double angle = std::numbers::pi * x;
    return Eigen::Vector3d(-radius_mm * std::cos(angle), height_mm * y,
                           radius_mm * std::sin(angle));
  });
}

/// Returns a sphere of radius 1 without the part below `lowest`. The closer this is to -1, the
/// longer is its neck.
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

/// Returns a mesh without the triangles for which `drop` returns true.
inline SurfaceMesh Without(SurfaceMesh mesh,
                           const std::function<bool(const Eigen::Vector3d&)>& drop) {
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return drop((mesh.points_mm[t[0]] + mesh.points_mm[t[1]] + mesh.points_mm[t[2]]) / 3);
  });
  return mesh;
}

/// Returns a cube with faces of n x n squares, projected to a sphere. It is closed.
inline SurfaceMesh Sphere(int n, double radius_mm) {
  SurfaceMesh mesh;
  std::map<std::array<int, 3>, int32_t> numbers;
  const auto vertex = [&](std::array<int, 3> at) {
    const auto [entry, is_new] =
        numbers.try_emplace(at, static_cast<int32_t>(mesh.points_mm.size()));
    if (is_new) {
      const Eigen::Vector3d p =
          2 * Eigen::Vector3d(at[0], at[1], at[2]) / n - Eigen::Vector3d::Ones();
      mesh.points_mm.push_back(radius_mm * p.normalized());
    }
    return entry->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int u = 0; u < n; ++u) {
        for (int v = 0; v < n; ++v) {
          const auto at = [&](int du, int dv) {
            std::array<int, 3> place;
            place[axis] = side;
            place[(axis + 1) % 3] = u + du;
            place[(axis + 2) % 3] = v + dv;
            return vertex(place);
          };
          std::array<int32_t, 4> square = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
          if (side == 0) std::swap(square[1], square[3]);
          mesh.triangles.push_back({square[0], square[1], square[2]});
          mesh.triangles.push_back({square[0], square[2], square[3]});
        }
      }
    }
  }
  return mesh;
}

/// Returns a torus with a ring of radius `ring_mm` and a tube of radius `tube_mm`.
inline SurfaceMesh Torus(int around, int across, double ring_mm, double tube_mm) {
  SurfaceMesh mesh;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * k / across;
      const double out = ring_mm + tube_mm * std::cos(b);
      mesh.points_mm.push_back({out * std::cos(a), out * std::sin(a), tube_mm * std::sin(b)});
    }
  }
  const auto at = [=](int i, int k) { return i % around * across + k % across; };
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return mesh;
}

/// Returns the surface of a plate of 5 x 3 unit cubes, with two of them missing: genus 2.
inline SurfaceMesh DoubleTorus() {
  const auto solid = [](int x, int y, int z) {
    return x >= 0 && x < 5 && y >= 0 && y < 3 && z == 0 && !(y == 1 && (x == 1 || x == 3));
  };
  SurfaceMesh mesh;
  std::map<std::array<int, 3>, int32_t> numbers;
  const auto vertex = [&](std::array<int, 3> p) {
    const auto [entry, is_new] =
        numbers.try_emplace(p, static_cast<int32_t>(mesh.points_mm.size()));
    if (is_new) mesh.points_mm.push_back(Eigen::Vector3d(p[0], p[1], p[2]));
    return entry->second;
  };
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (!solid(x, y, 0)) continue;
      for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {0, 1}) {
          std::array<int, 3> cube = {x, y, 0}, next = cube;
          next[axis] += 2 * side - 1;
          if (solid(next[0], next[1], next[2])) continue;
          const auto at = [&](int du, int dv) {
            std::array<int, 3> place = cube;
            place[axis] += side;
            place[(axis + 1) % 3] += du;
            place[(axis + 2) % 3] += dv;
            return vertex(place);
          };
          std::array<int32_t, 4> square = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
          if (side == 0) std::swap(square[1], square[3]);
          mesh.triangles.push_back({square[0], square[1], square[2]});
          mesh.triangles.push_back({square[0], square[2], square[3]});
        }
      }
    }
  }
  return mesh;
}

}  // namespace slicefarm::texture
