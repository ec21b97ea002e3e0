#pragma once

#include "common/model/options/cutter.h"
#include "services/milling/algo/push/edge_push.h"

namespace slicefarm::milling {

/// Finds where a bull nose that is moved along the fiber touches a part of an edge. `side`: 1 for
/// the contact at the high end of the gouged interval, -1 for the low end. Returns the position s
/// of this contact on the part, in [0, length]. If the cutter does not reach the part, returns the
/// position nearest to the cutter.
///
/// The point at s is from + s step; along(s) and across(s) are its FiberPoint fields, and width(s)
/// is the width of `piece` at its height. At the contact, side * along(s) + sqrt(width(s)^2 -
/// across(s)^2) is largest. The function is concave. Its derivative gives the search direction.
/// Where the square root is not real, the derivative of width - |across| gives the direction. The
/// search uses false position and bisection.
///
/// REQUIRES: the heights of the part are on the arc of `piece`; length >= 0. Cost: about ten steps
/// of 15 ns.
double BullContact(const ProfilePiece& piece, const FiberPoint& from, const FiberPoint& step,
                   double length, double side);

}  // namespace slicefarm::milling
