#pragma once

#include <string_view>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "common/model/path.h"

namespace slicefarm {

/// Makes a path of the usual width through the points of a text such as "(0 0, 9 0, 9 9)".
inline Path MakePathOrDie(std::string_view points, bool closed = false) {
  Path path;
  path.closed = closed;
  path.points = MakeLineOrDie(points);
  path.widths_nm = {450'000};
  return path;
}

/// Returns the total length of all lines.
inline double TotalMm(const std::vector<Polyline>& lines) {
  double length_nm = 0;
  for (const Polyline& line : lines) length_nm += Length(line);
  return length_nm / kNmPerMm;
}

}  // namespace slicefarm
