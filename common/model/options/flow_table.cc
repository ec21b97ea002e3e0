#include "common/model/options/flow_table.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/base/text.h"

namespace slicefarm {
namespace {

absl::Status BadTable(std::string_view why) {
  return absl::InvalidArgumentError(
      fmt::format("factors by length in mm, as 0,0.5;2,0.9;10,1: {}", why));
}

/// Returns the text of a point without quotes and spaces. OrcaSlicer puts each point on a line of
/// its own; in some of its presets the line break is written as a backslash and an n.
std::string_view TrimmedPoint(std::string_view text) {
  constexpr std::string_view kBreak = "\\n";
  text = Trim(text, "\" \t\r\n");
  return Trim(text.starts_with(kBreak) ? text.substr(kBreak.size()) : text);
}

absl::StatusOr<FlowPoint> PointOf(std::string_view text) {
  const std::vector<std::string_view> parts = Split(TrimmedPoint(text), ",");
  const auto number = [&](size_t part) { return ToNumber(Trim(parts[part])); };
  if (parts.size() != 2 || !number(0) || !number(1))
    return BadTable(fmt::format("'{}' is not LENGTH,FACTOR", text.substr(0, 20)));
  const FlowPoint point{*number(0) + 0.0, *number(1) + 0.0};  // no negative zeros
  if (!(0 <= point.length_mm && point.length_mm <= kMaxFlowLengthMm))
    return BadTable(fmt::format("a length of {} mm is not in the range 0 to {}", point.length_mm,
                                kMaxFlowLengthMm));
  if (!(0 <= point.factor && point.factor <= kMaxFlowFactor))
    return BadTable(
        fmt::format("a factor of {} is not in the range 0 to {}", point.factor, kMaxFlowFactor));
  return point;
}

}  // namespace

absl::StatusOr<FlowTable> ParseFlowTable(std::string_view text) {
  FlowTable table;
  for (const std::string_view item : Split(text, ";")) {
    const auto point = PointOf(item);
    if (!point.ok()) return point.status();
    if (table.empty() && point->length_mm != 0) return BadTable("the first length is not 0");
    if (!table.empty() && point->length_mm <= table.back().length_mm)
      return BadTable(
          fmt::format("the length {} mm is not greater than the one before it", point->length_mm));
    if (std::ssize(table) == kMaxFlowPoints)
      return BadTable(fmt::format("more than {} points", kMaxFlowPoints));
    table.push_back(*point);
  }
  if (table.size() < 2) return BadTable("fewer than two points");
  if (table.back().factor != 1) return BadTable("the last factor is not 1");
  return table;
}

std::string PrintFlowTable(const FlowTable& table) {
  std::string text;
  for (const auto& [length_mm, factor] : table)
    text += fmt::format("{}{},{}", text.empty() ? "" : ";", length_mm, factor);
  return text;
}

double FlowAt(const FlowTable& table, double length_mm) {
  const auto above = std::ranges::upper_bound(table, length_mm, {}, &FlowPoint::length_mm);
  if (above == table.end()) return table.back().factor;
  if (above == table.begin()) return table.front().factor;
  const FlowPoint& below = *(above - 1);
  const double share = (length_mm - below.length_mm) / (above->length_mm - below.length_mm);
  return below.factor + share * (above->factor - below.factor);
}

}  // namespace slicefarm
