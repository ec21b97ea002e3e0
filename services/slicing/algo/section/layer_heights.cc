#include "services/slicing/algo/section/layer_heights.h"

#include <fmt/core.h>

#include <string>

#include "common/geometry/point.h"
#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::slicing {
namespace {

absl::Status HeightError(std::string_view setting, Coord got_nm) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{} must be above 0, not {} nm", setting, got_nm),
                   {{"setting", std::string(setting)}, {"got", std::to_string(got_nm)}});
}

}  // namespace

absl::StatusOr<std::vector<LayerPlane>> LayerPlanes(Coord top_nm, const SlicingOptions& options) {
  const Coord first = options.first_layer_height_nm, height = options.layer_height_nm;
  if (first <= 0) return HeightError("first_layer_height", first);
  if (height <= 0) return HeightError("layer_height", height);
  if (first / 2 >= top_nm)
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
        fmt::format("the part is {} mm high, which is less than half of the first layer",
                    ToMm(top_nm)),
        {{"limit", std::to_string(first / 2)}, {"got", std::to_string(top_nm)}});
  // Layer k >= 1 is cut at first + (k - 1) height + height / 2 < top.
  const Coord room = top_nm - first - height / 2;
  const int64_t count = 1 + (room > 0 ? (room + height - 1) / height : 0);
  if (count > limits::kMaxLayers)
    return LimitError(Reason::kMeshTooLarge, "layers", limits::kMaxLayers, count);
  std::vector<LayerPlane> planes;
  planes.reserve(static_cast<size_t>(count));
  planes.push_back({{0, first, first}, first / 2});
  for (int32_t k = 1; k < count; ++k) {
    const Coord bottom = first + (k - 1) * height;
    planes.push_back({{k, bottom + height, height}, bottom + height / 2});
  }
  return planes;
}

}  // namespace slicefarm::slicing
