#pragma once

#include "common/model/options/cutter.h"
#include "services/milling/algo/push/edge_push.h"

namespace slicefarm::milling {

/// Where on a part of an edge, from + s step, a bull nose that comes along the fiber touches it: s
/// in [0, length] for which side along(s) + sqrt(width(s)^2 - across(s)^2) is largest. Where the
/// cutter does not reach the fiber, the s at which it is nearest to that.
///
/// The function is concave: its derivative, or outside of where it is defined that of
/// width - |across|, tells the way; its root is bracketed, by false position and halving.
/// REQUIRES: the heights of the part lie on the arc of `piece`; length >= 0.
/// Cost: about ten steps of 15 ns.
double BullContact(const ProfilePiece& piece, const FiberPoint& from, const FiberPoint& step,
                   double length, double side);

}  // namespace slicefarm::milling
