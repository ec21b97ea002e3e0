#include "common/picture/colour.h"

#include <algorithm>

namespace slicefarm {

Colour Mix(Colour a, Colour b, double t) {
  return {a.red + (b.red - a.red) * t, a.green + (b.green - a.green) * t,
          a.blue + (b.blue - a.blue) * t};
}

Colour ScaleColour(double fraction) {
  constexpr Colour kStops[] = {{0.27, 0.00, 0.33},
                               {0.23, 0.32, 0.55},
                               {0.13, 0.57, 0.55},
                               {0.37, 0.79, 0.38},
                               {0.99, 0.91, 0.15}};
  constexpr int kSpans = 4;
  const double at = std::clamp(fraction, 0.0, 1.0) * kSpans;
  const int span = std::min(static_cast<int>(at), kSpans - 1);
  return Mix(kStops[span], kStops[span + 1], at - span);
}

}  // namespace slicefarm
