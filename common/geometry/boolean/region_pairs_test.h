#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Two regions that are difficult for boolean operations: they touch, share edges, have edges a
/// nanometre apart, or are slivers. Islands are simple and disjoint.
struct RegionPair {
  std::string_view kind;
  MultiPolygon a, b;
};

/// Makes a pair of regions. `pick(n)`: returns a choice of 0 .. n - 1, from a generator or from the
/// bytes of a fuzzer.
RegionPair MakeRegionPair(const std::function<uint32_t(uint32_t)>& pick);

}  // namespace slicefarm
