#pragma once

#include <cstdint>

namespace slicefarm::ordering {

/// Remaining work of a search, in judged moves or lines of sight. Work is counted and not timed, so
/// that the result does not depend on the machine.
struct WorkBudget {
  int64_t moves = 0;
};

}  // namespace slicefarm::ordering
