#include "common/model/bead_section.h"

#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <string>

#include "common/base/error.h"

namespace slicefarm {
namespace {

constexpr double kRoundLoss = 1 - std::numbers::pi / 4;

}  // namespace

Coord Spacing(Coord width_nm, Coord height_nm) {
  return width_nm - std::llround(static_cast<double>(height_nm) * kRoundLoss);
}

absl::Status CheckSpacing(std::string_view setting, Coord width_nm, Coord height_nm) {
  if (Spacing(width_nm, height_nm) > 0) return absl::OkStatus();
  const double width_mm = ToMm(static_cast<double>(width_nm));
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
      fmt::format(
          "{} = {} mm is too narrow for a layer height of {} mm: lines would have no spacing",
          setting, width_mm, ToMm(static_cast<double>(height_nm))),
      {{"setting", std::string(setting)}, {"value", fmt::format("{}", width_mm)}});
}

Coord WidthForSpacing(Coord spacing_nm, Coord height_nm) {
  return spacing_nm + std::llround(static_cast<double>(height_nm) * kRoundLoss);
}

double SectionMm2(Coord width_nm, Coord height_nm) {
  const double width = ToMm(static_cast<double>(width_nm));
  const double height = ToMm(static_cast<double>(height_nm));
  if (width < height) return std::numbers::pi / 4 * width * width;
  return height * (width - height * kRoundLoss);
}

Coord WidthToFill(Coord strip_nm, Coord height_nm) {
  const Coord width = WidthForSpacing(strip_nm, height_nm);
  if (width >= height_nm) return width;
  const double area = static_cast<double>(strip_nm) * static_cast<double>(height_nm);
  return std::llround(std::sqrt(area * 4 / std::numbers::pi));
}

}  // namespace slicefarm
