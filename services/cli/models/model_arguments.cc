#include "services/cli/models/model_arguments.h"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/model/limits.h"

namespace slicefarm::cli {
namespace {

/// Reads `count` numbers separated by commas.
absl::StatusOr<std::vector<double>> Numbers(std::string_view option, std::string_view text,
                                            size_t count) {
  std::vector<double> numbers;
  for (const std::string_view item : Split(text, ",")) {
    const auto number = ToNumber(Trim(item));
    if (!number.has_value()) break;
    numbers.push_back(*number);
  }
  if (numbers.size() != count || Split(text, ",").size() != count) {
    return Malformed(
        fmt::format("{} {}: {} numbers, separated by commas, are needed", option, text, count));
  }
  return numbers;
}

absl::StatusOr<std::array<double, 3>> ScaleOf(const std::string& text) {
  if (text.empty()) return std::array<double, 3>{1, 1, 1};
  const bool uniform = text.find(',') == std::string::npos;
  const auto numbers = Numbers("--scale", text, uniform ? 1 : 3);
  if (!numbers.ok()) return numbers.status();
  const auto at = [&](size_t i) { return (*numbers)[uniform ? 0 : i]; };
  const std::array<double, 3> scale = {at(0), at(1), at(2)};
  for (const double factor : scale) {
    if (factor <= 0) return Malformed(fmt::format("--scale {}: it must be more than 0", text));
  }
  return scale;
}

double UnitOf(const std::string& name) {
  if (name == "inch") return 25.4;
  if (name == "m") return 1000;
  if (name == "cm") return 10;
  return 1;
}

}  // namespace

absl::StatusOr<Placement> PlacementOf(const JobOptions& options) {
  Placement placement;
  placement.unit_mm = UnitOf(options.units);
  const auto scale = ScaleOf(options.scale);
  if (!scale.ok()) return scale.status();
  placement.scale = *scale;
  placement.rotate_deg = {0, 0, options.rotate_z_deg};
  if (!std::isfinite(options.rotate_z_deg)) return Malformed("--rotate-z: not a number");
  if (!options.rotate.empty()) {
    const auto angles = Numbers("--rotate", options.rotate, 3);
    if (!angles.ok()) return angles.status();
    placement.rotate_deg = {(*angles)[0], (*angles)[1], (*angles)[2]};
  }
  for (const std::string& text : options.centers) {
    const auto center = Numbers("--center", text, 2);
    if (!center.ok()) return center.status();
    const double limit = ToMm(limits::kMaxCoord);
    if (std::abs((*center)[0]) > limit || std::abs((*center)[1]) > limit) {
      return Malformed(fmt::format("--center {}: more than {} mm from the origin", text, limit));
    }
    placement.centers.push_back({FromMm((*center)[0]), FromMm((*center)[1])});
  }
  return placement;
}

OfModel TakeApart(const std::string& text, char separator, const std::vector<std::string>& known) {
  OfModel best;
  for (const std::string& name : known) {
    if (!text.starts_with(name + separator) || name.size() < best.name.size()) continue;
    best = {name, text.substr(name.size() + 1)};
  }
  return best;
}

absl::StatusOr<int> CopiesOf(const std::string& text, const OfModel& of) {
  const auto count = ToNumber(Trim(of.what));
  if (of.name.empty() || !count || *count != std::floor(*count) || *count < 1 ||
      *count > limits::kMaxObjects) {
    return Malformed(
        fmt::format("--copies {}: MODEL=N is needed, with the name of one of the models and a "
                    "number from 1 to {}",
                    text, limits::kMaxObjects));
  }
  return static_cast<int>(*count);
}

}  // namespace slicefarm::cli
