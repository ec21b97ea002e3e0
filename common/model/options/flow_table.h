#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm {

/// Which part of its plastic a line of some length gets.
struct FlowPoint {
  double length_mm = 0;
  double factor = 1;

  friend bool operator==(const FlowPoint&, const FlowPoint&) = default;
};

/// By ascending length, the first one 0. The last factor is 1: longer lines get all of it.
using FlowTable = std::vector<FlowPoint>;

/// OrcaSlicer's.
inline constexpr std::string_view kSmallAreaFlowTable =
    "0,0;0.2,0.4444;0.4,0.6145;0.6,0.7059;0.8,0.7619;1.5,0.8571;2,0.8889;3,0.9231;5,0.952;10,1";

/// `LENGTH,FACTOR` with `;` between points, each one in quotes or not.
/// Errors: InvalidArgument for fewer than two points or more than kMaxFlowPoints, what is no pair
/// of numbers, lengths that do not begin at 0 or do not rise or exceed kMaxFlowLengthMm, factors
/// out of [0, kMaxFlowFactor], a last factor other than 1.
absl::StatusOr<FlowTable> ParseFlowTable(std::string_view text);
inline constexpr int kMaxFlowPoints = 100;
inline constexpr double kMaxFlowLengthMm = 1000;
inline constexpr double kMaxFlowFactor = 2;

/// As ParseFlowTable reads it.
std::string PrintFlowTable(const FlowTable& table);

/// In proportion between the points. REQUIRES: what ParseFlowTable asks for. Cost: O(log points).
double FlowAt(const FlowTable& table, double length_mm);

}  // namespace slicefarm
