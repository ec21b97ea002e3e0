#pragma once

#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill {

/// The curve g of least energy  l^2 |g'|^2 + l^4 |g''|^2 + |g - curve|^2,  integrated along the
/// curve, with l = `length_nm`: short (first term), not bent (second), and where it was (third;
/// without it a closed curve would shrink to a point). A wave of 2 pi l keeps a third of its
/// height, one three times as long nine tenths. The ends of an open curve stay.
///
/// Its Euler-Lagrange equation  g - l^2 g'' + l^4 g'''' = curve  is solved at points about l / 2
/// apart by five-point differences: one convolution with their Green's function, which is the
/// solution at once, so no step can be too long. Curves shorter than 4 l come back as they are.
/// Cost: O(n + m), n points of the curve, 50 steps for each of its m = 2 length / l points.
Curve Smoothed(const Curve& curve, double length_nm);

}  // namespace slicefarm::infill
