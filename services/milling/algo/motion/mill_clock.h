#pragma once

#include <span>
#include <vector>

#include "common/base/cancel_token.h"
#include "services/milling/algo/motion/mill_move.h"

namespace slicefarm::milling {

/// How a machine runs a move.
struct MoveTime {
  double seconds = 0;
  double fastest_mm_s = 0;  ///< what it reaches anywhere on its way
};

/// Times of a program's moves, by the jerk-limited look-ahead of common/kinematics: a corner is cut
/// by the tolerance, as LinuxCNC does it, and the machine comes to rest where it goes over from
/// rapid moves to feed moves and back. The first move comes from an unknown place: 0. Once
/// cancelled, those of later moves are 0: ask the token. Cost: O(chords).
std::vector<MoveTime> TimesOf(std::span<const MillMove> moves, const MillingOptions& options,
                              const CancelToken& cancel = {});

/// Lowers the feeds of moves to what the machine reaches on them, in steps of a twentieth.
void LowerFeeds(const MillingOptions& options, std::span<MillMove> moves,
                const CancelToken& cancel = {});

}  // namespace slicefarm::milling
