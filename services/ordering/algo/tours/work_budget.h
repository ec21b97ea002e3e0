#pragma once

#include <cstdint>

namespace slicefarm::ordering {

/// Work that may still be spent on improvement, in moves judged. Counted, not timed: the result
/// does not depend on the machine.
struct WorkBudget {
  int64_t moves = 0;
};

}  // namespace slicefarm::ordering
