#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm {

/// Consecutive layers, counted from 1.
struct LayerGroup {
  int32_t first = 1;
  int32_t count = 1;

  friend bool operator==(const LayerGroup&, const LayerGroup&) = default;
};

/// Parses the setting extra_solid_infills. `5` is every 5th layer. `5#2` is two consecutive layers
/// that begin with every 5th one. `1,7#2,9` are layers 1, 7, 8 and 9. Layers are counted from 1.
/// Errors: InvalidArgument for an empty list, for numbers that are not whole or outside 1 to
/// limits::kMaxLayers, and for more than kMaxLayerGroups groups.
absl::StatusOr<std::vector<LayerGroup>> ParseSolidLayers(std::string_view text);
inline constexpr int kMaxLayerGroups = 1000;

/// Returns the list in the form that ParseSolidLayers reads.
std::string PrintSolidLayers(const std::vector<LayerGroup>& groups);

/// Returns true if the groups contain a layer. A single group is repeated at the interval of its
/// first layer. `layer`: index within the object, from 0. Cost: O(groups).
bool ContainsLayer(const std::vector<LayerGroup>& groups, int32_t layer);

}  // namespace slicefarm
