#pragma once

#include <prometheus/histogram.h>
#include <prometheus/registry.h>

#include <utility>
#include <vector>

#include "common/stage/stage_list.h"

namespace slicefarm::coordinator {

/// Metric slicefarm_stage_seconds{stage}: time of each stage for a job, summed over the job's
/// tasks. The caller of the stage measures it.
class StageSeconds {
 public:
  /// Registers the metric in `registry`, which must outlive this object.
  explicit StageSeconds(prometheus::Registry& registry);

  /// Adds the times of one computed job. Skips stages with the time zero, because the job's process
  /// does not have them.
  void Observe(const StageTimes& times);

 private:
  std::vector<std::pair<Stage, prometheus::Histogram*>> stages_;
};

}  // namespace slicefarm::coordinator
