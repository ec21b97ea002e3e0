#pragma once

#include <functional>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/fields/direction_field.h"
#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill {

/// Box in which streamlines are laid out, in mm.
struct StreamBox {
  double min_x_mm = 0, min_y_mm = 0;
  double max_x_mm = 0, max_y_mm = 0;

  friend bool operator==(const StreamBox&, const StreamBox&) = default;
};

/// Parameters of streamlines.
struct StreamOptions {
  double z_mm = 0;
  bool across = false;  ///< true to follow the directions perpendicular to the field's
  /// Function that returns the requested distance between lines at a point, in mm. 0: no lines
  /// there.
  std::function<double(double x_mm, double y_mm)> separation_mm;
};

/// Smallest distance between two streamlines, as a share of the separation (the requested
/// distance).
inline constexpr double kEndShare = 2.0 / 3;
/// Relative error of the total length above which streamlines are laid out again.
inline constexpr double kMostBias = 0.01;
/// Returns evenly spaced lines in a box, along a field of directions or perpendicular to it (Jobard
/// and Lefer, "Creating evenly-spaced streamlines of arbitrary density", 1997). Each new line
/// starts beside an existing line, at the separation (StreamOptions::separation_mm). The line grows
/// in both directions. It ends if it leaves the box, meets a degenerate point, or is nearer than
/// kEndShare of the separation to another line; or it closes. Then a grid search fills remaining
/// gaps, so that no gap of two separations is left. Where lines diverge and converge, gaps range
/// from 2/3 to 4/3 of the separation, so that they are correct on average. If the relative error of
/// the total length exceeds kMostBias, the lines are laid out again, at most twice, with the
/// separation scaled by this error. Finally the errors of gaps are distributed over neighbours
/// (EvenGaps).
///
/// Integration: classic Runge-Kutta of order 4. Directions have no sign, so each stage's direction
/// is reversed if it disagrees with the last step. The step is halved if the direction changes by
/// more than 6 degrees within it. After straight parts are simplified, points are within 0.01 mm of
/// the line.
///
/// Errors: REQUEST_TOO_LARGE for more than limits::kMaxLinesPerFill, kMaxFieldCells or
/// kMaxStreamPoints. Cost: O(length / step) field evaluations, and as many searches of a few
/// neighbours.
absl::StatusOr<std::vector<Curve>> Streamlines(const StreamBox& box,
                                               const DirectionField& directions,
                                               const StreamOptions& options);

/// Cached result of the last call of Streamlines, for the next layer if its field, box and spacing
/// are the same.
struct StreamMemo {
  StreamBox box{};
  Coord spacing_nm = 0;
  std::vector<Curve> curves{};
};

}  // namespace slicefarm::infill
