#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm {

/// Measured pressure advance at a flow and an acceleration.
struct AdvancePoint {
  double advance = 0;
  double flow_mm3_s = 0;
  double acceleration_mm_s2 = 0;

  friend bool operator==(const AdvancePoint&, const AdvancePoint&) = default;
};

/// Parses points `ADVANCE,FLOW,ACCELERATION`, separated by `;`. Errors: InvalidArgument for a point
/// that is not three numbers of 0 or more, for two points with the same flow and acceleration, and
/// for more than kMaxAdvancePoints points.
absl::StatusOr<std::vector<AdvancePoint>> ParseAdvancePoints(std::string_view text);
inline constexpr int kMaxAdvancePoints = 1000;

/// Returns the points in the form that ParseAdvancePoints reads.
std::string PrintAdvancePoints(const std::vector<AdvancePoint>& points);

/// Pressure advance as a function of flow and acceleration, as in OrcaSlicer: monotone cubic curves
/// over the flow, one for each acceleration with at least two points, and such a curve over the
/// accelerations. Outside the measured range the value at the nearest end is used.
class AdvanceModel {
 public:
  explicit AdvanceModel(const std::vector<AdvancePoint>& points);

  /// Returns true if no acceleration has two points. Then the model has no values.
  bool empty() const { return curves_.empty(); }
  /// Returns the pressure advance, rounded to 0.001. REQUIRES: not empty. Cost: O(n) for n points.
  double At(double flow_mm3_s, double acceleration_mm_s2) const;

 private:
  /// Values by position, both sorted by position.
  struct Spline {
    std::vector<double> at, values;
    double Value(double position) const;
  };
  std::map<double, Spline> curves_;  ///< key: acceleration
};

}  // namespace slicefarm
