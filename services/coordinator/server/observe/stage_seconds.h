#pragma once

#include <prometheus/histogram.h>
#include <prometheus/registry.h>

#include <utility>
#include <vector>

#include "common/stage/stage_list.h"

namespace slicefarm::coordinator {

/// slicefarm_stage_seconds{stage}: what each stage took for a job, summed over its tasks, as its
/// caller sees it.
class StageSeconds {
 public:
  /// The registry must outlive it.
  explicit StageSeconds(prometheus::Registry& registry);

  /// The times of one computed job. Stages that its process does not have took no time, and are not
  /// counted.
  void Observe(const StageTimes& times);

 private:
  std::vector<std::pair<Stage, prometheus::Histogram*>> stages_;
};

}  // namespace slicefarm::coordinator
