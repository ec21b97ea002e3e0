#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// A line along the middle of a narrow region, with the region's width at each point.
/// INVARIANT: as many thicknesses as points, at least two.
struct ThickLine {
  bool closed = false;  ///< the last point joins the first, which is not repeated
  std::vector<Point> points;
  std::vector<Coord> thickness_nm;

  friend bool operator==(const ThickLine&, const ThickLine&) = default;
};

/// Length in nm, the closing edge included.
double Length(const ThickLine& line);

/// Area in nm^2 of the trapezoids along the line.
double Area(const ThickLine& line);

/// Takes `length_nm` off the end of an open line. Empty if nothing is left.
void CutEnd(ThickLine& line, double length_nm);

/// Lets the end of an open line go on by `length_nm`, straight on and as thick as it is there. The
/// direction is that of the line's last `length_nm` or so, not that of a tiny last edge.
void ExtendEnd(ThickLine& line, double length_nm);

void Reverse(ThickLine& line);

/// Drops points that a straight line with linearly changing thickness passes within the tolerance,
/// in place and in thickness. Cost: O(n log n) as a rule.
ThickLine SimplifyThickLine(const ThickLine& line, Coord tolerance_nm);

}  // namespace slicefarm::beading
