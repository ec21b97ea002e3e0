#pragma once

#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill {

/// Returns the curve g that minimizes the integral of  l^2 |g'|^2 + l^4 |g''|^2 + |g - curve|^2
/// along the curve, with l = `length_nm`. The first term keeps g short, the second prevents bends,
/// and the third keeps g near the curve. Without the third term, a closed curve would shrink to a
/// point. A wave of length 2 pi l keeps a third of its height, a wave three times as long keeps
/// nine tenths. The ends of an open curve do not move.
///
/// The Euler-Lagrange equation  g - l^2 g'' + l^4 g'''' = curve  is solved at points about l / 2
/// apart by five-point differences. The solution is a convolution with the Green's function of
/// these differences, so there is no time step that could be too long. Curves shorter than 4 l are
/// returned unchanged. Cost: O(n + m), n points of the curve, 50 steps for each of its m = 2 length
/// / l points.
Curve Smoothed(const Curve& curve, double length_nm);

}  // namespace slicefarm::infill
