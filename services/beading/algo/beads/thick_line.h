#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// Line along the middle of a narrow region, with the region's width at each point. INVARIANT:
/// there are as many thicknesses as points, and at least two.
struct ThickLine {
  /// True if an edge connects the last point to the first one. The first point is not repeated.
  bool closed = false;
  std::vector<Point> points;
  std::vector<Coord> thickness_nm;

  friend bool operator==(const ThickLine&, const ThickLine&) = default;
};

/// Returns the length in nm, including the closing edge of a closed line.
double Length(const ThickLine& line);

/// Returns the area in nm^2 that the line covers: the sum of its edges' trapezoids.
double Area(const ThickLine& line);

/// Cuts `length_nm` off the end of an open line. The line is empty if nothing is left.
void CutEnd(ThickLine& line, double length_nm);

/// Extends the end of an open line by `length_nm`, straight and with the thickness of the end. The
/// direction is that of about the last `length_nm` of the line, because the last edge may be tiny.
void ExtendEnd(ThickLine& line, double length_nm);

/// Reverses the direction of the line.
void Reverse(ThickLine& line);

/// Returns the line without points that are not needed: between the remaining points, a straight
/// line with linearly changing thickness deviates by at most the tolerance, in position and in
/// thickness. Cost: usually O(n log n), n points.
ThickLine SimplifyThickLine(const ThickLine& line, Coord tolerance_nm);

/// Returns the line without points between edges shorter than `least_nm`, as long as the line
/// deviates by at most `tolerance_nm` there, in position and in thickness. Longer edges and the
/// ends of the list of points remain. A loop keeps at least three points. Cost: as
/// SimplifyThickLine.
ThickLine MergeShortEdges(const ThickLine& line, Coord least_nm, Coord tolerance_nm);

}  // namespace slicefarm::beading
