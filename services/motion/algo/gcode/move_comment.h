#pragma once

#include <cstddef>
#include <string_view>

#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Returns the purpose of move `index` in PrusaSlicer's words: "perimeter", "move to first infill
/// point", "lift Z", "retract". Cost: O(1); for a travel, O(moves up to the next bead).
std::string_view CommentOn(const Toolpath& path, size_t index);

}  // namespace slicefarm::motion
