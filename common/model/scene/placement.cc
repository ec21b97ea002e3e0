#include "common/model/scene/placement.h"

#include <fmt/core.h>

#include <cmath>
#include <string>

#include "common/base/error.h"
#include "common/model/scene/rotation.h"

namespace slicefarm {
namespace {

absl::Status FactorError(std::string_view name, double got) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{} must be a finite number{}, not {}", name,
                               name == "rotate_deg" ? "" : " above 0", got),
                   {{"setting", std::string(name)}, {"got", fmt::format("{}", got)}});
}

bool IsFactor(double value) { return std::isfinite(value) && value > 0; }

}  // namespace

absl::Status CheckPlacement(const Placement& placement) {
  if (!IsFactor(placement.unit_mm)) return FactorError("unit_mm", placement.unit_mm);
  for (const double scale : placement.scale)
    if (!IsFactor(scale)) return FactorError("scale", scale);
  for (const double angle : placement.rotate_deg)
    if (!std::isfinite(angle)) return FactorError("rotate_deg", angle);
  return absl::OkStatus();
}

Transform TransformOf(const Placement& placement) {
  Transform transform = Transform::Zero();
  transform.leftCols<3>() = RotationXyz(placement.rotate_deg);
  for (int axis = 0; axis < 3; ++axis)
    transform.col(axis) *= placement.unit_mm * placement.scale[static_cast<size_t>(axis)];
  return transform;
}

}  // namespace slicefarm
