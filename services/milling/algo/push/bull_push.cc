#include "services/milling/algo/push/bull_push.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::milling {
namespace {

constexpr int kMaxSteps = 80;

/// Indicates by the sign of `value` in which direction along the edge the end of the gouged
/// interval moves outwards. If `smooth`, `value` is the derivative times a positive factor.
/// Otherwise the cutter at this position does not reach the fiber, and `value` points back to the
/// range where it does.
struct Slant {
  double value = 0;
  bool smooth = false;
};

class BullEdge {
 public:
  BullEdge(const ProfilePiece& piece, const FiberPoint& from, const FiberPoint& step, double side)
      : piece_(piece), from_(from), step_(step), side_(side) {}

  Slant At(double s) const {
    const double height = from_.height + s * step_.height;
    const double across = from_.across + s * step_.across;
    const double root = std::sqrt(std::max(0.0, height * (2 * piece_.corner_mm - height)));
    const double width = piece_.flat_mm + root;
    const double square = (width - across) * (width + across);
    // All slants are multiplied by `root`, which does not change their sign. `root` is 0 only at
    // the tip, where the derivative of the width is infinite.
    const double growth = step_.height * (piece_.corner_mm - height);
    const double factor = step_.height == 0 ? 1 : root;
    if (!(square > 0)) return {growth - (across > 0 ? 1 : -1) * step_.across * factor, false};
    const double flat = side_ * step_.along * std::sqrt(square) - across * step_.across;
    return {flat * factor + width * growth, true};
  }

 private:
  const ProfilePiece& piece_;
  const FiberPoint& from_;
  const FiberPoint& step_;
  double side_;
};

/// Returns the root of the slant between two positions with different signs. Near the tip the
/// derivative of the width is infinite, so the position must be exact to the last digits.
double RootOf(const BullEdge& edge, double low, Slant at_low, double high, Slant at_high) {
  const double precision = 1e-14 * (high - low);
  double weight_low = at_low.value, weight_high = at_high.value;
  int side = 0;
  for (int i = 0; i < kMaxSteps && high - low > 4 * precision; ++i) {
    double middle = (low + high) / 2;
    if (at_low.smooth && at_high.smooth && i % 4 != 3) {  // Illinois rule, never exactly at an end
      middle = (low * weight_high - high * weight_low) / (weight_high - weight_low);
      middle = std::clamp(middle, low + precision, high - precision);
    }
    const Slant here = edge.At(middle);
    if (here.value == 0 && here.smooth) return middle;
    if (here.value > 0) {
      low = middle, at_low = here, weight_low = here.value;
      weight_high = side == 1 ? weight_high / 2 : at_high.value;
      side = 1;
    } else {
      high = middle, at_high = here, weight_high = here.value;
      weight_low = side == -1 ? weight_low / 2 : at_low.value;
      side = -1;
    }
  }
  return at_low.smooth || !at_high.smooth ? low : high;
}

}  // namespace

double BullContact(const ProfilePiece& piece, const FiberPoint& from, const FiberPoint& step,
                   double length, double side) {
  const BullEdge edge(piece, from, step, side);
  const Slant first = edge.At(0);
  if (first.value <= 0 || length <= 0) return 0;
  const Slant last = edge.At(length);
  if (last.value >= 0) return length;
  return RootOf(edge, 0, first, length, last);
}

}  // namespace slicefarm::milling
