#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/path.h"

namespace slicefarm::infill {

/// Checks that no point of a path, and no middle of its segments, is more than 2 um outside.
inline void ExpectInside(const std::vector<Path>& paths, const MultiPolygon& region) {
  const MultiPolygon grown = FastOffset(region, 2'000);
  for (const Path& path : paths) {
    ASSERT_TRUE(WellFormed(path));
    for (size_t i = 0; i < path.points.size(); ++i) {
      const size_t before = i > 0 ? i - 1 : path.closed ? path.points.size() - 1 : 0;
      const Point a = path.points[i], b = path.points[before];
      ASSERT_TRUE(Inside(a, grown)) << a.x << ", " << a.y;
      ASSERT_TRUE(Inside({(a.x + b.x) / 2, (a.y + b.y) / 2}, grown)) << a.x << ", " << a.y;
    }
  }
}

}  // namespace slicefarm::infill
