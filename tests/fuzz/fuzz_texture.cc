#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "services/texture/algo/pattern/computed_heights.h"
#include "services/texture/algo/pattern/section.h"
#include "services/texture/algo/pattern/texture_file.h"

namespace slicefarm::texture {
namespace {

/// Slices a texture and walks across it.
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
  spec->detail = 4;  // what it costs is not what is looked for
  if (spec->count > 8) spec->count = 8;
  auto heights = ComputedHeights(*spec);
  if (!heights.ok()) return;
  const auto texture = TextureOf(*std::move(heights));
  if (texture.ok()) Use(*texture);
}

}  // namespace
}  // namespace slicefarm::texture

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace slicefarm::texture;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  UseText(bytes);
  const auto texture = TextureOfFile(bytes, {});
  if (texture.ok()) Use(*texture);
  return 0;
}
