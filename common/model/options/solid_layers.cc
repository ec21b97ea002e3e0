#include "common/model/options/solid_layers.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/base/text.h"
#include "common/model/limits.h"

namespace slicefarm {
namespace {

absl::Status MalformedLayers(std::string_view why) {
  return absl::InvalidArgumentError(fmt::format("layers, as 5 or 5#2 or 1,7,9: {}", why));
}

std::optional<int32_t> LayerNumber(std::string_view text) {
  const auto number = ToNumber(Trim(text));
  if (!number.has_value() || *number != std::floor(*number)) return std::nullopt;
  if (*number < 1 || *number > limits::kMaxLayers) return std::nullopt;
  return static_cast<int32_t>(*number);
}

/// Returns the group `N`, `N#` or `N#K`.
std::optional<LayerGroup> GroupOf(std::string_view text) {
  const size_t sharp = text.find('#');
  const auto first = LayerNumber(text.substr(0, sharp));
  if (!first.has_value()) return std::nullopt;
  const std::string_view rest =
      sharp == std::string_view::npos ? std::string_view() : Trim(text.substr(sharp + 1));
  const auto count = rest.empty() ? std::optional<int32_t>(1) : LayerNumber(rest);
  if (!count.has_value()) return std::nullopt;
  return LayerGroup{*first, *count};
}

}  // namespace

absl::StatusOr<std::vector<LayerGroup>> ParseSolidLayers(std::string_view text) {
  std::vector<LayerGroup> groups;
  for (const std::string_view item : Split(text, ",")) {
    const auto group = GroupOf(item);
    if (!group.has_value())
      return MalformedLayers(fmt::format("'{}' is not a layer", Trim(item).substr(0, 20)));
    if (std::ssize(groups) == kMaxLayerGroups)
      return MalformedLayers(fmt::format("more than {} groups", kMaxLayerGroups));
    groups.push_back(*group);
  }
  if (groups.empty()) return MalformedLayers("the list is empty");
  return groups;
}

std::string PrintSolidLayers(const std::vector<LayerGroup>& groups) {
  std::string text;
  for (const LayerGroup& group : groups) {
    text += fmt::format("{}{}", text.empty() ? "" : ",", group.first);
    if (group.count > 1) text += fmt::format("#{}", group.count);
  }
  return text;
}

bool ContainsLayer(const std::vector<LayerGroup>& groups, int32_t layer) {
  const bool repeats = groups.size() == 1;
  return std::ranges::any_of(groups, [&](const LayerGroup& group) {
    const int64_t above = int64_t{layer} + 1 - group.first;
    if (above < 0) return false;
    return (repeats ? above % group.first : above) < group.count;
  });
}

}  // namespace slicefarm
