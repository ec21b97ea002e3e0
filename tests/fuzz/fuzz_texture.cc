#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "common/geometry/vector.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/stl_reader.h"
#include "services/texture/algo/pattern/computed_heights.h"
#include "services/texture/algo/pattern/image_heights.h"
#include "services/texture/algo/pattern/section.h"

namespace slicefarm::texture {
namespace {

/// Slices a texture and samples it along a line.
void Use(const Texture& texture) {
  const double heights[] = {0.01 * texture.height_mm, 0.5 * texture.height_mm,
                            0.99 * texture.height_mm};
  for (const Section& section : SectionsOf(texture, heights)) {
    std::vector<double> shares;
    section.Crossings({0, 0}, texture.tile_mm, &shares);
    section.Crossings({0, texture.tile_mm.y() / 2}, {texture.tile_mm.x(), texture.tile_mm.y() / 2},
                      &shares);
    section.Contains(texture.tile_mm / 3);
  }
}

void UseText(std::string_view text) {
  auto spec = ParseTextureSpec(text);
  if (!spec.ok()) return;
  if (ParseTextureSpec(TextureSpecText(*spec)).value() != *spec) __builtin_trap();
  spec->detail = 4;  // limits the cost; slow inputs are no findings here
  if (spec->count > 8) spec->count = 8;
  auto heights = ComputedHeights(*spec);
  if (!heights.ok()) return;
  const auto texture = TextureOf(*std::move(heights));
  if (texture.ok()) Use(*texture);
}

void UseImage(std::string_view png) {
  auto heights = ImageHeights(png, {});
  if (!heights.ok()) return;
  const auto texture = TextureOf(*std::move(heights));
  if (texture.ok()) Use(*texture);
}

void UseSolid(std::string_view stl) {
  const auto raw = slicing::ReadBinaryStl(stl, limits::kMaxMeshCoordinateMm, {});
  if (!raw.ok()) return;
  SurfaceMesh solid;
  for (const Vector3& p : raw->positions) solid.points_mm.push_back({p.x(), p.y(), p.z()});
  for (const auto& [a, b, c] : raw->triangles)
    solid.triangles.push_back(
        {static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(c)});
  const auto texture = TextureOf(std::move(solid), Eigen::Vector2d(0, 0));
  if (texture.ok()) Use(*texture);
}

}  // namespace
}  // namespace slicefarm::texture

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace slicefarm::texture;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  UseText(bytes);
  UseImage(bytes);
  UseSolid(bytes);
  return 0;
}
