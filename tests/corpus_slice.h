#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "tests/corpus_file.h"

namespace slicefarm {

/// Returns the outlines of tests/corpus/slices/NAME.
inline MultiPolygon CorpusSlice(const std::string& name) {
  std::istringstream text(CorpusFile("slices/" + name));
  double unused = 0;
  text >> unused >> unused;
  std::vector<Polygon> rings;
  for (size_t count = 0; text >> count;) {
    Polygon& ring = rings.emplace_back(count);
    for (Point& point : ring) {
      double x = 0, y = 0;
      text >> x >> y;
      point = {FromMm(x), FromMm(y)};
    }
  }
  return Union(rings, FillRule::kEvenOdd);
}

}  // namespace slicefarm
