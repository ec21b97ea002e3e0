#include "services/slicing/algo/sample_meshes_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <utility>

#include "common/model/scene/rotation.h"

namespace slicefarm::slicing {
namespace {

/// Quick random generator of Numerical Recipes: gives the same numbers on all machines.
class Numbers {
 public:
  explicit Numbers(uint32_t seed) : state_(seed) {}
  uint32_t Below(size_t bound) {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<uint32_t>((uint64_t{state_} * bound) >> 32);
  }

 private:
  uint32_t state_;
};

double SnappedToLayer(double z, double layer) {
  return layer > 0 ? (std::round(z / layer - 0.5) + 0.5) * layer : z;
}

void AppendBytes(std::string& out, const void* data, size_t size) {
  out.append(static_cast<const char*>(data), size);
}

}  // namespace

RawMesh BoxMesh(const Vector3& min, const Vector3& max) {
  RawMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back(
        {i & 1 ? max.x() : min.x(), i & 2 ? max.y() : min.y(), i & 4 ? max.z() : min.z()});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

RawMesh Cube(double x, double y, double z, double size) {
  return BoxMesh({x, y, z}, {x + size, y + size, z + size});
}

RawMesh TetrahedronMesh(double size) {
  return {{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

RawMesh TorusMesh(const TorusShape& shape) {
  RawMesh mesh;
  for (int i = 0; i < shape.around; ++i) {
    const auto [sin_turn, cos_turn] = SineCosineDegrees(360.0 * i / shape.around);
    for (int j = 0; j < shape.sides; ++j) {
      const auto [sin_side, cos_side] = SineCosineDegrees(360.0 * j / shape.sides);
      const double radius = shape.ring_radius + shape.tube_radius * cos_side;
      const double z = shape.tube_radius * (1 + sin_side);
      mesh.positions.push_back(
          {radius * cos_turn, radius * sin_turn, SnappedToLayer(z, shape.snap_to_layer)});
    }
  }
  const auto at = [&shape](int i, int j) {
    return static_cast<uint32_t>(i % shape.around * shape.sides + j % shape.sides);
  };
  for (int i = 0; i < shape.around; ++i) {
    for (int j = 0; j < shape.sides; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

RawMesh Joined(const RawMesh& a, const RawMesh& b) {
  RawMesh mesh = a;
  const uint32_t offset = static_cast<uint32_t>(a.positions.size());
  mesh.positions.insert(mesh.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& t : b.triangles)
    mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return mesh;
}

RawMesh Moved(RawMesh mesh, const Vector3& by) {
  for (Vector3& p : mesh.positions) p = {p.x() + by.x(), p.y() + by.y(), p.z() + by.z()};
  return mesh;
}

RawMesh TurnedInsideOut(RawMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

RawMesh Mirrored(RawMesh mesh) {
  for (Vector3& p : mesh.positions) p.x() = -p.x();
  return TurnedInsideOut(std::move(mesh));
}

RawMesh Shuffled(RawMesh mesh, uint32_t seed) {
  Numbers numbers(seed);
  auto& triangles = mesh.triangles;
  for (size_t i = triangles.size(); i > 1; --i)
    std::swap(triangles[i - 1], triangles[numbers.Below(i)]);
  for (auto& t : triangles) std::rotate(t.begin(), t.begin() + numbers.Below(3), t.end());
  return mesh;
}

RawMesh WithoutTriangle(RawMesh mesh, size_t index) {
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<ptrdiff_t>(index));
  return mesh;
}

std::string ToBinaryStl(const RawMesh& mesh) {
  std::string bytes(80, ' ');
  const uint32_t count = static_cast<uint32_t>(mesh.triangles.size());
  AppendBytes(bytes, &count, sizeof count);
  for (const auto& t : mesh.triangles) {
    float numbers[12] = {0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      const Vector3& p = mesh.positions[t[i]];
      numbers[3 + 3 * i] = static_cast<float>(p.x());
      numbers[4 + 3 * i] = static_cast<float>(p.y());
      numbers[5 + 3 * i] = static_cast<float>(p.z());
    }
    AppendBytes(bytes, numbers, sizeof numbers);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string ToAsciiStl(const RawMesh& mesh) {
  std::string text = "solid sample\n";
  for (const auto& t : mesh.triangles) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (const uint32_t corner : t) {
      const Vector3& p = mesh.positions[corner];
      fmt::format_to(std::back_inserter(text), "      vertex {} {} {}\n", p.x(), p.y(), p.z());
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid sample\n";
}

std::string ToObj(const RawMesh& mesh) {
  std::string text = "# sample\n";
  for (const Vector3& p : mesh.positions)
    fmt::format_to(std::back_inserter(text), "v {} {} {}\n", p.x(), p.y(), p.z());
  for (const auto& t : mesh.triangles)
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

}  // namespace slicefarm::slicing
