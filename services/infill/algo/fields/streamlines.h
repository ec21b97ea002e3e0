#pragma once

#include <functional>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/fields/direction_field.h"
#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill {

/// Box that contains streamlines, in mm.
struct StreamBox {
  double min_x_mm = 0, min_y_mm = 0;
  double max_x_mm = 0, max_y_mm = 0;

  friend bool operator==(const StreamBox&, const StreamBox&) = default;
};

/// Parameters of streamlines.
struct StreamOptions {
  double z_mm = 0;
  bool across = false;  ///< follow the family of directions perpendicular to the field's directions
  /// Function that returns the requested distance between lines at a point, in mm. 0: there are no
  /// lines.
  std::function<double(double x_mm, double y_mm)> separation_mm;
};

/// Smallest distance between two streamlines, as a share of the separation.
inline constexpr double kEndShare = 2.0 / 3;
/// Largest permitted relative error of the total length of streamlines.
inline constexpr double kMostBias = 0.01;
/// Returns evenly spaced lines in a box, along a field of directions or perpendicular to it (Jobard
/// and Lefer, "Creating evenly-spaced streamlines of arbitrary density", 1997). Each new line
/// starts beside an existing line, at the separation. The line grows in both directions until it
/// leaves the box, meets a degenerate point, is nearer than kEndShare of the separation to another
/// line, or closes. Then a grid search fills remaining gaps, so that no gap of two separations is
/// left. Where lines diverge and converge, gaps range from 2/3 to 4/3 of the separation, so that
/// they are correct on average. If the total length is still wrong by more than kMostBias, the
/// lines are laid out again at most twice, with the separation scaled by the error. Finally the
/// gaps are distributed over neighbours (EvenGaps).
///
/// Integration: classic Runge-Kutta of order 4. Directions have no sign, so that each stage's
/// direction is reversed if it disagrees with the last step. The step is halved if the direction
/// changes by more than 6 degrees within it. Points are within 0.01 mm of the line, after straight
/// parts are simplified.
///
/// Errors: REQUEST_TOO_LARGE for more than limits::kMaxLinesPerFill, kMaxFieldCells or
/// kMaxStreamPoints. Cost: O(length / step) field evaluations, and as many searches of a few
/// neighbours.
absl::StatusOr<std::vector<Curve>> Streamlines(const StreamBox& box,
                                               const DirectionField& directions,
                                               const StreamOptions& options);

/// Result of the last call, for layers with the same fields and boxes.
struct StreamMemo {
  StreamBox box{};
  Coord spacing_nm = 0;
  std::vector<Curve> curves{};
};

}  // namespace slicefarm::infill
