#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/filament_use.h"
#include "common/stage/stages.h"
#include "services/coordinator/algo/dispatch/range_executor.h"

namespace slicefarm::coordinator {

struct JobInput {
  SliceInput meshes;
  JobSettings settings;
  std::string settings_text;  ///< effective settings as `key = value` lines, quoted at the end of
                              ///< the G-code
  std::vector<std::string> warnings = {};  ///< of the settings: the report begins with them
};

/// What a job came to, besides its G-code.
struct JobReport {
  std::vector<MeshReport> meshes;
  ProgramStats stats;  ///< of all layers
  int32_t layer_count = 0;
  double object_height_mm = 0;
  double print_time_s = 0;
  double travel_mm = 0;  ///< between layers included
  FilamentUse filament;
  StageTimes stage_times;
  std::vector<std::string> warnings;  ///< such as what a mesh lacks
};

struct JobOutput {
  std::string gcode;
  JobReport report;
};

struct PipelineProgress {
  int32_t layers_total = 0;  ///< 0 until the meshes are sliced
  int32_t layers_done = 0;
};

/// Errors: NOTHING_TO_PRINT if no layer has an outline.
absl::Status CheckPrintable(std::span<const SlicedLayer> layers);

/// The whole way from meshes to G-code:
///   1 slicing   2 planning   3 ranges with halo (range_split.h)   4 executor   5 assembly
/// The same for the embedded process and for the coordinator; only the stages and the executor
/// differ.
class JobPipeline {
 public:
  JobPipeline(const SlicingStage& slicing, const PlanningStage& planning,
              const MotionStage& motion, RangeExecutor& executor)
      : slicing_(slicing), planning_(planning), motion_(motion), executor_(executor) {}

  /// `progress` may be called from any thread, one call at a time.
  /// Errors: those of the stages and of the executor.
  absl::StatusOr<JobOutput> Run(const StageCall& call, JobInput input,
                                const std::function<void(PipelineProgress)>& progress) const;

 private:
  const SlicingStage& slicing_;
  const PlanningStage& planning_;
  const MotionStage& motion_;
  RangeExecutor& executor_;
};

}  // namespace slicefarm::coordinator
