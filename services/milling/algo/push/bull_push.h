#pragma once

#include "common/model/options/cutter.h"
#include "services/milling/algo/push/edge_push.h"

namespace slicefarm::milling {

/// Returns the contact of a bull nose that moves along the fiber with a part of an edge. The points
/// of the part are from + s step. The result is the s in [0, length] at which side * along(s) +
/// sqrt(width(s)^2 - across(s)^2) is largest. If the cutter does not reach the fiber, the result is
/// the s at which it is nearest.
///
/// The function is concave. Its derivative gives the search direction; outside of its domain, the
/// derivative of width - |across| does. The root is bracketed, by false position and bisection.
/// REQUIRES: the heights of the part are on the arc of `piece`; length >= 0. Cost: about ten steps
/// of 15 ns.
double BullContact(const ProfilePiece& piece, const FiberPoint& from, const FiberPoint& step,
                   double length, double side);

}  // namespace slicefarm::milling
