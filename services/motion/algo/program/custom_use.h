#pragma once

#include <string_view>

#include "common/model/layers/layer.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Returns the totals of custom G-code: the beads that it prints, and the time of all its moves.
/// The machine stands still before and after the code. If the first move is a travel, it takes no
/// time, because its start is not known.
FeatureUse UseOfCode(std::string_view code, const MotionOptions& options);

}  // namespace slicefarm::motion
