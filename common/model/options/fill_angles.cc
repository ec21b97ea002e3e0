#include "common/model/options/fill_angles.h"

#include <fmt/core.h>

#include <cmath>
#include <optional>

#include "common/base/text.h"

namespace slicefarm {
namespace {

constexpr double kFullTurn = 360;

absl::Status Malformed(std::string_view why) {
  return absl::InvalidArgumentError(fmt::format("angles by layer, as 0,45,+30 or 90#2: {}", why));
}

/// Returns the number of repetitions of an item, from the text after `#`.
std::optional<int> CountOf(std::string_view text) {
  const auto count = ToNumber(text);
  if (!count.has_value() || *count != std::floor(*count)) return std::nullopt;
  if (*count < 1 || *count > kMaxAngleSteps) return std::nullopt;
  return static_cast<int>(*count);
}

std::optional<AngleStep> StepOf(std::string_view text) {
  const bool relative = text.starts_with("+") || text.starts_with("-");
  const auto degrees = ToNumber(text.starts_with("+") ? text.substr(1) : text);
  if (!degrees.has_value() || !(std::abs(*degrees) <= kFullTurn)) return std::nullopt;
  return AngleStep{relative, *degrees};
}

}  // namespace

absl::StatusOr<std::vector<AngleStep>> ParseFillAngles(std::string_view text) {
  std::vector<AngleStep> steps;
  for (std::string_view item : Split(text, ",")) {
    item = Trim(item);
    const size_t sharp = item.find('#');
    const auto count =
        sharp == std::string_view::npos ? std::optional(1) : CountOf(item.substr(sharp + 1));
    const auto step = StepOf(Trim(item.substr(0, sharp)));
    if (!count.has_value() || !step.has_value())
      return Malformed(fmt::format("'{}' is not an angle", item.substr(0, 20)));
    if (std::ssize(steps) + *count > kMaxAngleSteps)
      return Malformed(fmt::format("more than {} layers", kMaxAngleSteps));
    steps.insert(steps.end(), static_cast<size_t>(*count), *step);
  }
  if (steps.empty()) return Malformed("the list is empty");
  return steps;
}

std::string PrintFillAngles(const std::vector<AngleStep>& steps) {
  std::string text;
  for (size_t i = 0; i < steps.size();) {
    size_t end = i + 1;
    while (end < steps.size() && steps[end] == steps[i]) ++end;
    const bool plus = steps[i].relative && !std::signbit(steps[i].degrees);
    text += fmt::format("{}{}{}", text.empty() ? "" : ",", plus ? "+" : "", steps[i].degrees);
    if (end - i > 1) text += fmt::format("#{}", end - i);
    i = end;
  }
  return text;
}

double FillAngleAt(const std::vector<AngleStep>& steps, double base_degrees, int32_t layer) {
  const int64_t count = std::ssize(steps);
  double turned = 0;
  int64_t at = layer;
  // Goes back to the last absolute angle, through the whole list at most once.
  for (; at >= 0 && at > layer - count; --at) {
    const AngleStep& step = steps[static_cast<size_t>(at % count)];
    turned += step.degrees;
    if (!step.relative) break;
  }
  const bool found = at >= 0 && at > layer - count;
  if (!found) {
    // All items are relative: the turn of the whole list counts once per complete repetition.
    double round = 0, rest = 0;
    const int64_t layers = layer + 1;
    for (int64_t i = 0; i < count; ++i) {
      round += steps[static_cast<size_t>(i)].degrees;
      if (i < layers % count) rest += steps[static_cast<size_t>(i)].degrees;
    }
    turned = base_degrees + rest + static_cast<double>(layers / count) * round;
  }
  const double angle = std::fmod(turned, kFullTurn);
  return angle < 0 ? angle + kFullTurn : angle;
}

}  // namespace slicefarm
