#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

// Sections of periodic minimal surfaces f(x, y, z) = 0 with period 2 pi. The surface is scaled so
// that the density is correct over a period in z. The scale follows from the mean length of the
// section per area (coarea formula, integrated numerically; patterns_test checks the density).
// Single layers deviate: the gyroid -5.9 to +12.8 %, Schwarz' D -7 to +16 %, Fischer and Koch's S
// -11 to +13 %.

/// Gyroid: f = sin x cos y + sin y cos z + sin z cos x.
MakePattern Gyroid;
/// Schwarz' D surface: f = cos x cos y cos z - sin x sin y sin z.
MakePattern SchwarzD;
/// Fischer and Koch's S surface: f = cos 2x sin y cos z + cos 2y sin z cos x + cos 2z sin x cos y.
MakePattern FischerKochS;

}  // namespace slicefarm::infill
