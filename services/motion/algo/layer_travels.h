#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/offset/paths_within.h"
#include "common/model/layers/program_summary.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Plans travels between layers around the bed's excluded areas. `MotionOptions::travel_area` is
/// the bed without these areas; if it is empty, travels are straight. All points are in G-code
/// coordinates.
class LayerTravels {
 public:
  /// `options` must outlive this object.
  explicit LayerTravels(const MotionOptions& options);

  /// Returns the corners of the travel from `from` to `to`. A straight travel has none.
  std::vector<Point> Corners(Point from, Point to) const;

  /// Returns the G-code of the moves to `corners`, one per line.
  std::string MovesTo(const std::vector<Point>& corners) const;

  /// Returns the G-code of the moves from `from` towards the layer's entry, at the height of the
  /// layer's travel; empty if the straight travel avoids the excluded areas.
  std::string To(const LayerSummary& layer, Point from) const;

  /// Returns the position after running `gcode` from `from`. Returns `from` if no area is excluded.
  Point After(std::string_view gcode, Point from) const;

 private:
  const MotionOptions& options_;
  PathsWithin travels_;
};

}  // namespace slicefarm::motion
