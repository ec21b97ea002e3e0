#pragma once

#include <prometheus/family.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>

#include "common/stage/task.h"

namespace slicefarm::coordinator {

/// slicefarm_stage_seconds{stage}: what each stage took for a job, summed over its ranges, as its
/// caller sees it.
class StageSeconds {
 public:
  /// The registry must outlive it.
  explicit StageSeconds(prometheus::Registry& registry);

  /// Of a job that was computed.
  void Observe(const StageTimes& times);

 private:
  prometheus::Histogram& slicing_;
  prometheus::Histogram& beading_;
  prometheus::Histogram& infill_;
  prometheus::Histogram& ordering_;
  prometheus::Histogram& motion_;
};

}  // namespace slicefarm::coordinator
