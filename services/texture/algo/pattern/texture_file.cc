#include "services/texture/algo/pattern/texture_file.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <map>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::texture {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr size_t kStlHeader = 84, kStlFacet = 50;

template <typename Number>
Number NumberAt(std::string_view bytes, size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof(number));
  return number;
}

}  // namespace

absl::StatusOr<SurfaceMesh> ReadBinaryStl(std::string_view bytes) {
  const int64_t count = bytes.size() < kStlHeader ? 0 : NumberAt<uint32_t>(bytes, 80);
  if (count > limits::kMaxTriangles)
    return LimitError(Reason::kMeshTooLarge, "triangles of the texture", limits::kMaxTriangles,
                      count);
  if (bytes.size() < kStlHeader + static_cast<size_t>(count) * kStlFacet || count == 0)
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshTruncated,
                     fmt::format("the texture is neither a PNG image nor a binary STL: {} bytes, "
                                 "{} triangles",
                                 bytes.size(), count));
  SurfaceMesh mesh;
  std::map<std::array<float, 3>, int32_t> numbers;
  for (int64_t t = 0; t < count; ++t) {
    std::array<int32_t, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      std::array<float, 3> place;
      for (int axis = 0; axis < 3; ++axis) {
        const size_t at = kStlHeader + static_cast<size_t>(t) * kStlFacet + 12 + 12 * k + 4 * axis;
        place[axis] = NumberAt<float>(bytes, at) + 0.0F;  // -0 is 0
        if (place[axis] != place[axis])
          return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshNotFinite,
                           fmt::format("triangle {} of the texture has a coordinate that is no "
                                       "number",
                                       t + 1));
      }
      const auto [entry, is_new] =
          numbers.try_emplace(place, static_cast<int32_t>(mesh.points_mm.size()));
      if (is_new) mesh.points_mm.push_back({place[0], place[1], place[2]});
      triangle[k] = entry->second;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

absl::StatusOr<Texture> TextureOfFile(std::string_view bytes, const TextureFileOptions& options) {
  if (bytes.starts_with(kPngSignature)) {
    auto heights = ImageHeights(bytes, options.image);
    if (!heights.ok()) return heights.status();
    return TextureOf(*std::move(heights));
  }
  auto solid = ReadBinaryStl(bytes);
  if (!solid.ok()) return solid.status();
  return TextureOf(*std::move(solid), options.pitch_mm);
}

}  // namespace slicefarm::texture
