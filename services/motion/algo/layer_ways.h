#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/offset/ways_within.h"
#include "common/model/layers/program_summary.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Leads travel between layers round the bed's excluded areas (MotionOptions::room). All places are
/// the G-code's.
class LayerWays {
 public:
  /// `options` must outlive this.
  explicit LayerWays(const MotionOptions& options);

  /// Returns the corners of the way from `from` to `to`; none: it is straight.
  std::vector<Point> Corners(Point from, Point to) const;

  /// Returns the moves to these corners, one a line.
  std::string MovesTo(const std::vector<Point>& corners) const;

  /// Returns the moves that lead from `from` towards the layer's entry, at the height of its
  /// travel; empty if the straight way is free.
  std::string To(const LayerSummary& layer, Point from) const;

  /// Returns where G-code leaves the nozzle that stands at `from` before it.
  Point After(std::string_view gcode, Point from) const;

 private:
  const MotionOptions& options_;
  WaysWithin ways_;
};

}  // namespace slicefarm::motion
