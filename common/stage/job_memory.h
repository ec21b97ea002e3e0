#pragma once

#include <cstdint>

#include "absl/status/status.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/model/scene/placed_scene.h"

namespace slicefarm {

struct StageCall;

/// What a job holds in this process, as it comes and goes. Who reads what may be large says so
/// while it comes, so that a job is stopped before it takes the memory of others.
class JobMemory {
 public:
  enum class Kind { kMeshes, kOutlines, kPlan, kProgram };
  static constexpr int kKinds = 4;

  virtual ~JobMemory() = default;

  /// From now on the job has so many bytes of this kind; fewer than before is always well. May wait
  /// for others. Errors: see IsOutOfMemory; Cancelled.
  virtual absl::Status Hold(Kind kind, int64_t bytes) = 0;
};

/// True of errors of Hold: REQUEST_TOO_LARGE if the job would not fit if it were alone; OVERLOADED
/// if it makes room for another one, and may come again.
bool IsOutOfMemory(const absl::Status& status);

/// The metadata by which they are known.
inline constexpr char kMemoryKind[] = "memory";

/// Hold of the call's memory, where it has one.
absl::Status HoldMemory(const StageCall& call, JobMemory::Kind kind, int64_t bytes);

/// What layers and their plans take in memory, about. Cost: O(rings).
int64_t MemoryOf(const SlicedLayer& layer);
int64_t MemoryOf(const LayerPlan& plan);
int64_t MemoryOf(const ObjectSection& section);
int64_t MemoryOf(const Skirt& skirt);
/// What meshes take. Cost: O(parts).
int64_t MemoryOf(const PlacedScene& scene);

}  // namespace slicefarm
