#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::slicing {

/// The outlines of a first layer, shrunk by what it will spread, but thin places less: where the
/// material is w wide, it is max(min_width, w - 2 compensation) wide afterwards, and w if that is
/// below min_width already.
///
/// The width at a point of an outline is the diameter of the largest disc within the material that
/// touches the outline there and again on the other side, which is where the two tangents make an
/// angle below 45 degrees. Between 45 and 60 degrees it counts less and less; the sides of a corner
/// above 60 degrees are no thin place: they shrink, however small the corner. The shrinkage varies
/// continuously along an outline, and at reflex corners is round.
///
/// Promises: the result lies within the outlines; no point of it is missing that is farther than
/// `compensation` (+ 2 nm) from them; places min_width + 2 compensation wide shrink by the
/// compensation; no island vanishes, splits, or loses or gains a hole. An island for which that
/// fails, as for outlines that nearly touch, is compensated by a half, a quarter, an eighth or not
/// at all.
///
/// Shapes: disjoint islands as Union makes them; each is shrunk on its own. Units: nm. Errors:
/// none; a compensation of 0 or less changes nothing. Cost: O(n log n) where no place is thin; a
/// difference of about seven strips per mm of thin outline besides.
/// Source: measured, PrusaSlicer 2.5.0, elefant_foot_compensation 0.2 and 0.4, blades 0.4 to 3 mm
/// wide and wedges of 20 to 90 degrees. With min_width = width + spacing of the outer wall on the
/// first layer (0.4 + 0.357):
///   blade       0.4   0.5   0.6   0.8    1.0    1.2    1.5    2.0  3.0
///   becomes     0.4   0.5   0.6   0.758  0.758  0.799  1.100  1.6  2.6   here: 0.757, 0.757, 0.8
/// Wedges of up to 45 degrees keep their tip and ramp, those from 60 degrees on shrink evenly.
MultiPolygon ElephantFootCompensated(const MultiPolygon& outlines, Coord compensation_nm,
                                     Coord min_width_nm);

}  // namespace slicefarm::slicing
