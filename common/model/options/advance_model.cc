#include "common/model/options/advance_model.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "common/base/text.h"

namespace slicefarm {
namespace {

absl::Status BadPoints(std::string_view why) {
  return absl::InvalidArgumentError(fmt::format(
      "pressure advance by flow in mm3/s and acceleration in mm/s2, as 0.04,4,3000;0.03,8,3000: {}",
      why));
}

absl::StatusOr<AdvancePoint> AdvancePointOf(std::string_view text) {
  const std::vector<std::string_view> parts = Split(Trim(text, "\" \t\r\n"), ",");
  std::vector<double> numbers;
  for (const std::string_view part : parts)
    if (const auto number = ToNumber(Trim(part)); number && *number >= 0)
      numbers.push_back(*number + 0.0);  // no negative zeros
  if (parts.size() != 3 || numbers.size() != 3)
    return BadPoints(fmt::format("'{}' is not ADVANCE,FLOW,ACCELERATION", text.substr(0, 30)));
  return AdvancePoint{numbers[0], numbers[1], numbers[2]};
}

/// Returns the slope of a curve at an inner point, from the slopes on both sides: their weighted
/// harmonic mean, so that the curve does not overshoot; 0 at an extremum.
double SlopeAt(double before, double after, double width_before, double width_after) {
  if (before * after <= 0) return 0;
  const double first = 2 * width_after + width_before, second = width_after + 2 * width_before;
  return (first + second) / (first / before + second / after);
}

}  // namespace

absl::StatusOr<std::vector<AdvancePoint>> ParseAdvancePoints(std::string_view text) {
  std::vector<AdvancePoint> points;
  for (const std::string_view item : Split(text, ";")) {
    if (Trim(item).empty()) continue;
    const auto point = AdvancePointOf(item);
    if (!point.ok()) return point.status();
    if (std::ssize(points) == kMaxAdvancePoints)
      return BadPoints(fmt::format("more than {} points", kMaxAdvancePoints));
    for (const AdvancePoint& other : points)
      if (other.flow_mm3_s == point->flow_mm3_s &&
          other.acceleration_mm_s2 == point->acceleration_mm_s2)
        return BadPoints(fmt::format("two points have the flow {} and the acceleration {}",
                                     point->flow_mm3_s, point->acceleration_mm_s2));
    points.push_back(*point);
  }
  return points;
}

std::string PrintAdvancePoints(const std::vector<AdvancePoint>& points) {
  std::string text;
  for (const AdvancePoint& point : points)
    text += fmt::format("{}{},{},{}", text.empty() ? "" : ";", point.advance, point.flow_mm3_s,
                        point.acceleration_mm_s2);
  return text;
}

AdvanceModel::AdvanceModel(const std::vector<AdvancePoint>& points) {
  std::map<double, std::map<double, double>> advance;  // by acceleration and flow
  for (const AdvancePoint& point : points)
    advance[point.acceleration_mm_s2][point.flow_mm3_s] = point.advance;
  for (const auto& [acceleration, by_flow] : advance) {
    if (by_flow.size() < 2) continue;
    Spline& curve = curves_[acceleration];
    for (const auto& [flow, value] : by_flow) {
      curve.at.push_back(flow);
      curve.values.push_back(value);
    }
  }
}

double AdvanceModel::At(double flow_mm3_s, double acceleration_mm_s2) const {
  Spline over;
  for (const auto& [acceleration, curve] : curves_) {
    over.at.push_back(acceleration);
    over.values.push_back(curve.Value(flow_mm3_s));
  }
  constexpr double kSteps = 1000;
  return std::round(over.Value(acceleration_mm_s2) * kSteps) / kSteps;
}

double AdvanceModel::Spline::Value(double position) const {
  if (position <= at.front()) return values.front();
  if (position >= at.back()) return values.back();
  const auto i = static_cast<size_t>(std::ranges::upper_bound(at, position) - at.begin()) - 1;
  const auto width = [&](size_t k) { return at[k + 1] - at[k]; };
  const auto rise = [&](size_t k) { return (values[k + 1] - values[k]) / width(k); };
  const auto slope = [&](size_t k) {
    if (k == 0) return rise(0);
    if (k + 1 == at.size()) return rise(k - 1);
    return SlopeAt(rise(k - 1), rise(k), width(k - 1), width(k));
  };
  const double t = (position - at[i]) / width(i), rest = 1 - t;
  return values[i] * rest * rest * (1 + 2 * t) + values[i + 1] * t * t * (3 - 2 * t) +
         width(i) * (slope(i) * t * rest * rest - slope(i + 1) * t * t * rest);
}

}  // namespace slicefarm
