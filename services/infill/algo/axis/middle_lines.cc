#include "services/infill/algo/axis/middle_lines.h"

#include <utility>

#include "common/geometry/measure.h"
#include "services/infill/algo/axis/main_axis.h"

namespace slicefarm::infill {
namespace {

double LengthOf(const Polyline& line) {
  double length = 0;
  for (size_t i = 1; i < line.size(); ++i) length += Distance(line[i - 1], line[i]);
  return length;
}

}  // namespace

std::vector<Path> MiddleLines(const MultiPolygon& area, Coord width_nm, double least_nm) {
  std::vector<Path> paths;
  for (const PolygonWithHoles& island : area) {
    for (Polyline& line : MainAxis(island, {})) {
      if (LengthOf(line) < least_nm) continue;
      Path path;
      path.feature = Feature::kInternalInfill;
      path.widths_nm = {width_nm};
      path.points = std::move(line);
      paths.push_back(std::move(path));
    }
  }
  return paths;
}

}  // namespace slicefarm::infill
