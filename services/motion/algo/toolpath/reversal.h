#pragma once

#include <cstdint>

#include "common/model/options/region_motion.h"
#include "common/model/path.h"
#include "services/motion/algo/toolpath/overhang.h"

namespace slicefarm::motion {

/// Returns true if the direction of a loop is reversed in a layer (overhang_reverse): in every
/// second layer, if some place of the wall overhangs by more than the threshold. `layer`: index of
/// the layer; the second layer is the first with reversed walls. `below`: layer below; null: not
/// known, so that only a threshold of 0 reverses. Cost: one query of the layer below per mm.
bool IsReversed(const Path& path, const OverhangReversal& reversal, int32_t layer,
                const LayerBelow* below);

/// Returns a loop in the other direction, with the same start. REQUIRES: `path` is closed.
Path Reversed(Path path);

}  // namespace slicefarm::motion
