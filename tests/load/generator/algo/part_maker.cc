#include "tests/load/generator/algo/part_maker.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <numbers>
#include <vector>

#include "common/base/portable_math.h"
#include "tests/load/generator/algo/seeded.h"

namespace slicefarm::load {
namespace {

using Vertex = std::array<float, 3>;

constexpr size_t kHeaderBytes = 80;
constexpr size_t kTriangleBytes = 50;
constexpr std::array<std::string_view, 4> kMixNames = {"tiny", "medium", "huge", "mixed"};

static_assert(std::endian::native == std::endian::little, "as STL is");

class StlWriter {
 public:
  explicit StlWriter(uint32_t triangles)
      : bytes_(kHeaderBytes + sizeof triangles + triangles * kTriangleBytes, '\0'),
        next_(kHeaderBytes + sizeof triangles) {
    std::memcpy(bytes_.data() + kHeaderBytes, &triangles, sizeof triangles);
  }

  /// Writes a triangle without a normal; readers compute it from the vertices.
  void Triangle(const Vertex& a, const Vertex& b, const Vertex& c) {
    constexpr size_t kNormalBytes = sizeof(Vertex);
    char* at = bytes_.data() + next_ + kNormalBytes;
    for (const Vertex* vertex : {&a, &b, &c}) {
      std::memcpy(at, vertex->data(), sizeof *vertex);
      at += sizeof *vertex;
    }
    next_ += kTriangleBytes;
  }

  std::string Take() { return std::move(bytes_); }

 private:
  std::string bytes_;
  size_t next_;
};

/// Rings of vertices above each other, closed by a fan at the bottom and one at the top.
struct Lathe {
  int rings;
  int around;

  int Triangles() const { return 2 * around * (rings - 1) + 2 * around; }
};

constexpr Lathe LatheOf(PartSize size) {
  return size == PartSize::kMedium ? Lathe{.rings = 50, .around = 50}
                                   : Lathe{.rings = 500, .around = 500};
}

std::vector<Vertex> Rings(const Lathe& lathe, uint64_t seed) {
  SeededRandom random(seed);
  const double radius_mm = random.Uniform(10, 20);
  const double height_mm = random.Uniform(20, 40);
  const double flutes = std::floor(random.Uniform(3, 9));
  const double depth = random.Uniform(0.03, 0.10);  // fraction of the radius
  const double belly = random.Uniform(0.05, 0.20);
  std::vector<Vertex> vertices;
  vertices.reserve(static_cast<size_t>(lathe.rings) * lathe.around);
  for (int ring = 0; ring < lathe.rings; ++ring) {
    const double up = static_cast<double>(ring) / (lathe.rings - 1);
    const double profile = radius_mm * (1 + belly * Sin(up * std::numbers::pi));
    for (int i = 0; i < lathe.around; ++i) {
      const double angle_rad = 2 * std::numbers::pi * i / lathe.around;
      const double r = profile * (1 + depth * Cos(flutes * angle_rad));
      vertices.push_back({static_cast<float>(r * Cos(angle_rad)),
                          static_cast<float>(r * Sin(angle_rad)),
                          static_cast<float>(up * height_mm)});
    }
  }
  return vertices;
}

std::string MakeVase(const Lathe& lathe, uint64_t seed) {
  const std::vector<Vertex> vertices = Rings(lathe, seed);
  const auto at = [&](int ring, int i) -> const Vertex& {
    return vertices[static_cast<size_t>(ring) * lathe.around + i % lathe.around];
  };
  const int top = lathe.rings - 1;
  const Vertex foot = {0, 0, at(0, 0)[2]};
  const Vertex head = {0, 0, at(top, 0)[2]};
  StlWriter stl(static_cast<uint32_t>(lathe.Triangles()));
  for (int i = 0; i < lathe.around; ++i) {
    stl.Triangle(foot, at(0, i + 1), at(0, i));
    stl.Triangle(head, at(top, i), at(top, i + 1));
    for (int ring = 0; ring < top; ++ring) {
      stl.Triangle(at(ring, i), at(ring, i + 1), at(ring + 1, i + 1));
      stl.Triangle(at(ring, i), at(ring + 1, i + 1), at(ring + 1, i));
    }
  }
  return stl.Take();
}

std::string MakeBox(uint64_t seed) {
  SeededRandom random(seed);
  const Vertex size = {static_cast<float>(random.Uniform(4, 12)),
                       static_cast<float>(random.Uniform(4, 12)),
                       static_cast<float>(random.Uniform(4, 12))};
  // The bits 0, 1, 2 of i select x, y, z of corner i.
  const auto corner = [&](int i) -> Vertex {
    return {i & 1 ? size[0] : 0, i & 2 ? size[1] : 0, i & 4 ? size[2] : 0};
  };
  constexpr std::array<std::array<int, 4>, 6> kFaces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  StlWriter stl(12);
  for (const auto& face : kFaces) {
    stl.Triangle(corner(face[0]), corner(face[1]), corner(face[2]));
    stl.Triangle(corner(face[0]), corner(face[2]), corner(face[3]));
  }
  return stl.Take();
}

}  // namespace

std::string_view MixName(Mix mix) { return kMixNames[static_cast<size_t>(mix)]; }

std::optional<Mix> MixFromName(std::string_view name) {
  for (size_t i = 0; i < kMixNames.size(); ++i) {
    if (kMixNames[i] == name) return static_cast<Mix>(i);
  }
  return std::nullopt;
}

PartSize PickSize(Mix mix, uint64_t seed, uint64_t index) {
  if (mix == Mix::kTiny) return PartSize::kTiny;
  if (mix == Mix::kMedium) return PartSize::kMedium;
  if (mix == Mix::kHuge) return PartSize::kHuge;
  const double draw = SeededRandom::Of(seed, index).Uniform();
  if (draw < 0.80) return PartSize::kTiny;
  return draw < 0.98 ? PartSize::kMedium : PartSize::kHuge;
}

int TrianglesOf(PartSize size) { return size == PartSize::kTiny ? 12 : LatheOf(size).Triangles(); }

std::string MakePart(PartSize size, uint64_t seed) {
  return size == PartSize::kTiny ? MakeBox(seed) : MakeVase(LatheOf(size), seed);
}

}  // namespace slicefarm::load
