#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Two regions that a boolean operation may find hard: they touch, share edges, run beside each
/// other by a nanometre, or are slivers. Islands are simple and disjoint.
struct RegionPair {
  std::string_view kind;
  MultiPolygon a, b;
};

/// `pick(n)`: a choice of 0 .. n - 1, from a generator or from a fuzzer's bytes.
RegionPair MakeRegionPair(const std::function<uint32_t(uint32_t)>& pick);

}  // namespace slicefarm
