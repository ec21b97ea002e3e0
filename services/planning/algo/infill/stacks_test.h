#pragma once

#include <functional>
#include <string>

#include "common/geometry/text_format_test.h"
#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

inline constexpr Coord kStackHeight = 200'000;

/// Returns `count` layers, each with one region: the result of `outline` for its number.
inline ObjectStack StackOf(int count, const std::function<MultiPolygon(int)>& outline) {
  ObjectStack stack;
  for (int i = 0; i < count; ++i) {
    const MultiPolygon whole = outline(i);
    stack.push_back({i, (i + 1) * kStackHeight, kStackHeight, whole, whole});
  }
  return stack;
}

inline ObjectStack Prism(int count, std::string_view text) {
  return StackOf(count, [&](int) { return MakePolygonsOrDie(text); });
}

}  // namespace slicefarm::planning
