#pragma once

#include <cstddef>
#include <string_view>

#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Returns the purpose of a move in PrusaSlicer's words: "perimeter", "move to first infill point",
/// "lift Z", "retract". Cost: for a travel, the moves up to the next bead.
std::string_view CommentOn(const Toolpath& path, size_t index);

}  // namespace slicefarm::motion
