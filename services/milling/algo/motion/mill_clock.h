#pragma once

#include <span>
#include <vector>

#include "common/base/cancel_token.h"
#include "services/milling/algo/motion/mill_move.h"

namespace slicefarm::milling {

/// Duration and speed of a move.
struct MoveTime {
  double seconds = 0;
  double fastest_mm_s = 0;  ///< largest speed during the move
};

/// Returns the times of a program's moves, by the jerk-limited look-ahead of common/kinematics.
/// Corners are rounded within the tolerance, as LinuxCNC does it. The machine stops between rapid
/// moves and feed moves. The first move starts at an unknown position, so its time is 0. After
/// cancellation, the times of later moves are 0, so callers must check the token. Cost: O(chords).
std::vector<MoveTime> TimesOf(std::span<const MillMove> moves, const MillingOptions& options,
                              const CancelToken& cancel = {});

/// Lowers the feed of each move to the speed that the machine reaches on it, rounded up to a
/// twentieth of the programmed feed.
void LowerFeeds(const MillingOptions& options, std::span<MillMove> moves,
                const CancelToken& cancel = {});

}  // namespace slicefarm::milling
