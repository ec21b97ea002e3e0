#pragma once

#include <cstdint>

#include "absl/status/status.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/model/scene/placed_scene.h"

namespace slicefarm {

struct StageCall;

/// Account of the memory that a job uses in this program. Code that reads possibly large data
/// reports the data's size while it reads, so that a job is stopped before it uses the memory of
/// other jobs.
class JobMemory {
 public:
  enum class Kind { kMeshes, kOutlines, kPlan, kProgram };
  static constexpr int kKinds = 4;

  virtual ~JobMemory() = default;

  /// Sets the number of bytes of this kind that the job uses from now on. A reduction always
  /// succeeds. An increase may wait for other jobs. Errors: see IsOutOfMemory; Cancelled.
  virtual absl::Status Hold(Kind kind, int64_t bytes) = 0;
};

/// Returns true if `status` is a memory error of Hold. REQUEST_TOO_LARGE: the job would not fit
/// even without other jobs. OVERLOADED: the job must end, to free its memory for another job; it
/// may be retried.
bool IsOutOfMemory(const absl::Status& status);

/// Metadata key that marks the memory errors of Hold.
inline constexpr char kMemoryKind[] = "memory";

/// Calls Hold of the memory account of `call`, if it has one.
absl::Status HoldMemory(const StageCall& call, JobMemory::Kind kind, int64_t bytes);

/// Returns the approximate memory of layers and their plans, in bytes. Cost: O(rings).
int64_t MemoryOf(const SlicedLayer& layer);
int64_t MemoryOf(const LayerPlan& plan);
int64_t MemoryOf(const ObjectSection& section);
int64_t MemoryOf(const Skirt& skirt);
/// Returns the memory of meshes, in bytes. Cost: O(parts).
int64_t MemoryOf(const PlacedScene& scene);

}  // namespace slicefarm
