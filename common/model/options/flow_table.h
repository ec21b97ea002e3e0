#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm {

/// Point of a flow table: a line of this length gets this share of its normal plastic.
struct FlowPoint {
  double length_mm = 0;
  double factor = 1;

  friend bool operator==(const FlowPoint&, const FlowPoint&) = default;
};

/// Points, sorted by length; the first length is 0. The last factor is 1, so that longer lines get
/// all of their plastic.
using FlowTable = std::vector<FlowPoint>;

/// Default table of OrcaSlicer.
inline constexpr std::string_view kSmallAreaFlowTable =
    "0,0;0.2,0.4444;0.4,0.6145;0.6,0.7059;0.8,0.7619;1.5,0.8571;2,0.8889;3,0.9231;5,0.952;10,1";

/// Parses a table: points `LENGTH,FACTOR` separated by `;`, each optionally in quotes. Errors:
/// InvalidArgument for fewer than two points, for more than kMaxFlowPoints, or for a point that is
/// not a pair of numbers. The lengths must begin at 0, rise, and not exceed kMaxFlowLengthMm. The
/// factors must be in [0, kMaxFlowFactor], and the last factor must be 1.
absl::StatusOr<FlowTable> ParseFlowTable(std::string_view text);
inline constexpr int kMaxFlowPoints = 100;
inline constexpr double kMaxFlowLengthMm = 1000;
inline constexpr double kMaxFlowFactor = 2;

/// Returns the table in the form that ParseFlowTable reads.
std::string PrintFlowTable(const FlowTable& table);

/// Returns the factor for a length, interpolated linearly between the points. REQUIRES: a table
/// that ParseFlowTable would accept. Cost: O(log n) for n points.
double FlowAt(const FlowTable& table, double length_mm);

}  // namespace slicefarm
