#pragma once

#include <functional>
#include <vector>

#include "absl/status/statusor.h"
#include "services/infill/algo/fields/direction_field.h"
#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill {

struct StreamBox {
  double min_x_mm = 0, min_y_mm = 0;
  double max_x_mm = 0, max_y_mm = 0;

  friend bool operator==(const StreamBox&, const StreamBox&) = default;
};

struct StreamOptions {
  double z_mm = 0;
  bool across = false;  ///< along the other family, at right angles to the directions
  /// How far apart lines shall lie at a place, mm; 0: there are none.
  std::function<double(double x_mm, double y_mm)> separation_mm;
};

/// Evenly spaced lines along a field of directions, or across it, in a box (Jobard and Lefer,
/// "Creating evenly-spaced streamlines of arbitrary density", 1997). Each new line starts beside
/// one that is there, at the separation; it goes on both ways until it leaves the box, comes to a
/// degenerate place, or to within kEndShare of the separation from another line; or until it
/// closes. What is left open then is looked for on a grid, so that no gap of two separations stays.
/// Where lines spread and close in, gaps go from 2/3 to 4/3 of the separation, so that they are
/// right on average. Where all lines together are yet off by more than kMostBias, they are laid out
/// again at a separation that differs by as much, twice at most. At last the gaps are shared out
/// among neighbours (EvenGaps).
///
/// Integration: classic Runge-Kutta of order 4; each stage's direction is turned to go with the
/// last step, as directions have no sign; the step is halved where the direction turns by more than
/// 6 degrees within it. Points lie within 0.01 mm of the line, after smoothing out what is
/// straight.
///
/// Errors: as CheckLineCount; REQUEST_TOO_LARGE past kMaxFieldCells and kMaxStreamPoints. Cost:
/// O(length / step) field evaluations, and as many searches of a few neighbours.
inline constexpr double kEndShare = 2.0 / 3;
inline constexpr double kMostBias = 0.01;
absl::StatusOr<std::vector<Curve>> Streamlines(const StreamBox& box,
                                               const DirectionField& directions,
                                               const StreamOptions& options);

/// The lines that were asked for last, for layers whose fields and boxes are the same.
struct StreamMemo {
  StreamBox box{};
  Coord spacing_nm = 0;
  std::vector<Curve> curves{};
};

}  // namespace slicefarm::infill
