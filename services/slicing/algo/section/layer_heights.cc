#include "services/slicing/algo/section/layer_heights.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/geometry/point.h"
#include "common/model/limits.h"

namespace slicefarm::slicing {
namespace {

absl::Status HeightError(std::string_view setting, Coord got_nm) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{} must be above 0, not {} nm", setting, got_nm),
                   {{"setting", std::string(setting)}, {"got", std::to_string(got_nm)}});
}

/// A range also contains a layer if the range starts at most this much above the layer's bottom.
constexpr Coord kReachNm = 35'000;

/// Returns the layer height at `z_nm`, by linear interpolation between the given heights. Below the
/// first and above the last given z, their heights apply.
Coord HeightIn(const std::vector<LayerHeightAt>& profile, Coord z_nm) {
  const auto above = std::ranges::upper_bound(profile, z_nm, {}, &LayerHeightAt::z_nm);
  if (above == profile.begin()) return above->height_nm;
  const LayerHeightAt& low = *std::prev(above);
  if (above == profile.end()) return low.height_nm;
  const double share =
      static_cast<double>(z_nm - low.z_nm) / static_cast<double>(above->z_nm - low.z_nm);
  return low.height_nm +
         std::llround(share * static_cast<double>(above->height_nm - low.height_nm));
}

Coord HeightAt(Coord bottom_nm, const LayerHeights& heights) {
  if (!heights.profile.empty())
    return HeightIn(heights.profile, bottom_nm + heights.profile_above_nm);
  const Coord at = bottom_nm + kReachNm;
  for (const RangeInput& range : heights.ranges)
    if (range.from_nm <= at && at < range.to_nm) return range.layer_height_nm;
  return heights.others_nm;
}

/// Tolerance for the object's top: other programs write meshes that deviate from round numbers by
/// up to this.
constexpr Coord kRoundingNm = 100;

/// Returns true if the middle of a layer lies above the top.
bool IsCutAbove(Coord bottom_nm, Coord height_nm, Coord top_nm) {
  return 2 * bottom_nm + height_nm > 2 * (top_nm + kRoundingNm);
}

absl::Status CheckHeights(const LayerHeights& heights) {
  if (heights.first_nm <= 0) return HeightError("first_layer_height", heights.first_nm);
  if (heights.others_nm <= 0) return HeightError("layer_height", heights.others_nm);
  for (const RangeInput& range : heights.ranges)
    if (range.layer_height_nm <= 0) return HeightError("layer_height", range.layer_height_nm);
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::vector<LayerPlane>> LayerPlanes(Coord top_nm, const LayerHeights& heights) {
  if (absl::Status ok = CheckHeights(heights); !ok.ok()) return ok;
  const Coord first = heights.first_nm;
  if (top_nm <= 0 || IsCutAbove(0, first, top_nm))
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
        fmt::format("the part is {} mm high, less than half of the first layer", ToMm(top_nm)),
        {{"limit", std::to_string(first / 2)}, {"got", std::to_string(top_nm)}});
  std::vector<LayerPlane> planes = {{{0, first, first}, std::min(first / 2, top_nm - 1)}};
  for (Coord bottom = first;;) {
    const Coord height = HeightAt(bottom, heights);
    if (IsCutAbove(bottom, height, top_nm)) return planes;
    const auto index = static_cast<int32_t>(planes.size());
    if (index == limits::kMaxLayers) {
      const int64_t wanted = index + 1 + (top_nm - bottom - height / 2) / height;
      return LimitError(Reason::kMeshTooLarge, "layers", limits::kMaxLayers, wanted);
    }
    planes.push_back({{index, bottom + height, height}, std::min(bottom + height / 2, top_nm - 1)});
    bottom += height;
  }
}

void MeetTop(Coord top_nm, const HeightLimits& range, std::vector<LayerPlane>& planes) {
  constexpr size_t kChanged = 5;
  const size_t count = std::min(kChanged, planes.size() - 1);
  const std::span<LayerPlane> last = std::span(planes).last(count);
  Coord gap_nm = top_nm - planes.back().frame.print_z_nm;
  for (size_t i = 0; i < count; ++i) {
    Coord& height_nm = last[i].frame.height_nm;
    const Coord wanted_nm = height_nm + gap_nm / static_cast<Coord>(count - i);
    const Coord next_nm = std::clamp(wanted_nm, std::min(range.least_nm, height_nm),
                                     std::max(range.most_nm, height_nm));
    gap_nm -= next_nm - std::exchange(height_nm, next_nm);
  }
  Coord bottom_nm = count > 0 ? planes[planes.size() - count - 1].frame.print_z_nm : 0;
  for (LayerPlane& plane : last) {
    plane.frame.print_z_nm = bottom_nm + plane.frame.height_nm;
    plane.z_nm = std::min(bottom_nm + plane.frame.height_nm / 2, top_nm - 1);
    bottom_nm = plane.frame.print_z_nm;
  }
}

void LowerCuts(Coord least_nm, std::vector<LayerPlane>& planes) {
  for (size_t i = 1; i < planes.size(); ++i) {
    const Coord bottom_nm = planes[i].frame.print_z_nm - planes[i].frame.height_nm;
    planes[i].z_nm = std::min(planes[i].z_nm, bottom_nm + least_nm);
  }
}

absl::StatusOr<std::vector<LayerPlane>> PlanesBelow(std::span<const Coord> tops_nm) {
  if (std::ssize(tops_nm) > limits::kMaxLayers)
    return LimitError(Reason::kMeshTooLarge, "layers", limits::kMaxLayers, std::ssize(tops_nm));
  std::vector<LayerPlane> planes;
  Coord bottom = 0;
  for (const Coord top : tops_nm) {
    planes.push_back(
        {{static_cast<int32_t>(planes.size()), top, top - bottom}, bottom + (top - bottom) / 2});
    bottom = top;
  }
  return planes;
}

}  // namespace slicefarm::slicing
