#include "common/model/options/layer_heights.h"

#include <fmt/core.h>

#include "absl/status/status.h"
#include "common/base/text.h"

namespace slicefarm {
namespace {

constexpr double kLowestMm = 0.01;
constexpr double kHighestMm = 5;
constexpr double kMostZMm = 1e4;

}  // namespace

absl::StatusOr<std::vector<LayerHeightAt>> ParseLayerHeights(std::string_view text) {
  std::vector<LayerHeightAt> heights;
  if (text.empty()) return heights;
  const std::vector<std::string_view> items = Split(text, ";");
  if (items.size() % 2 != 0)
    return absl::InvalidArgumentError("must have a height for each z: z;height;z;height");
  if (items.size() / 2 > kMaxLayerHeightPoints)
    return absl::InvalidArgumentError(
        fmt::format("must have no more than {} heights", kMaxLayerHeightPoints));
  for (size_t i = 0; i < items.size(); i += 2) {
    const auto z = ToNumber(Trim(items[i])), height = ToNumber(Trim(items[i + 1]));
    if (!z || !height) return absl::InvalidArgumentError("must be numbers: z;height;z;height");
    if (!(0 <= *z && *z <= kMostZMm))
      return absl::InvalidArgumentError("must have each z at 0 mm or above");
    if (!(kLowestMm <= *height && *height <= kHighestMm))
      return absl::InvalidArgumentError(
          fmt::format("must have heights from {} to {} mm", kLowestMm, kHighestMm));
    const LayerHeightAt at = {FromMm(*z), FromMm(*height)};
    if (!heights.empty() && at.z_nm < heights.back().z_nm)
      return absl::InvalidArgumentError("must not decrease in z");
    heights.push_back(at);
  }
  return heights;
}

std::string PrintLayerHeights(const std::vector<LayerHeightAt>& heights) {
  std::string text;
  for (const LayerHeightAt& at : heights)
    text += fmt::format("{}{};{}", text.empty() ? "" : ";", ToMm(at.z_nm), ToMm(at.height_nm));
  return text;
}

}  // namespace slicefarm
