#include "common/kinematics/two_pass_planner.h"

#include <algorithm>

#include "common/kinematics/trapezoid.h"

namespace slicefarm {

void TwoPassPlanner::Add(const KinematicMove& move) {
  const KinematicMove limited = Limited(move);
  entry_v2_.push_back(moves_.empty() ? rules_.start_v2(limited, limits())
                                     : rules_.junction_v2(moves_.back(), limited, limits()));
  moves_.push_back(limited);
}

std::span<const MoveProfile> TwoPassPlanner::Stop() {
  const size_t count = moves_.size();
  profiles_.resize(count);
  entry_v2_.push_back(rules_.rest_v2);
  for (size_t i = count; i-- > 0;)
    entry_v2_[i] = std::min(entry_v2_[i], entry_v2_[i + 1] + ReachV2(moves_[i]));
  for (size_t i = 0; i < count; ++i) {
    const double top = moves_[i].speed_mm_s * moves_[i].speed_mm_s;
    entry_v2_[i + 1] = std::min(entry_v2_[i + 1], entry_v2_[i] + ReachV2(moves_[i]));
    profiles_[i] = Trapezoid(moves_[i], entry_v2_[i], top, entry_v2_[i + 1]);
  }
  moves_.clear();
  entry_v2_.clear();
  return profiles_;
}

}  // namespace slicefarm
