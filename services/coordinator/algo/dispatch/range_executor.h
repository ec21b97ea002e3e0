#pragma once

#include <functional>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/stage/stages.h"

namespace slicefarm::coordinator {

/// Runs all ranges of a job somewhere, in any order, with retries as it sees fit.
class RangeExecutor {
 public:
  virtual ~RangeExecutor() = default;

  /// Results are in the order of `tasks`. `layers_done` is told, from any thread but one call at a
  /// time, how many layers are finished. Errors: the first range's that cannot be made, or
  /// Cancelled.
  virtual absl::StatusOr<std::vector<RangeResult>> Execute(
      const StageCall& call, std::span<const RangeTask> tasks,
      const std::function<void(int32_t)>& layers_done) = 0;

  /// How many ranges can be worked on at once: what a job is cut for.
  virtual int Slots() const = 0;
};

}  // namespace slicefarm::coordinator
