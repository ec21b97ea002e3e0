#include "services/coordinator/server/observe/stage_seconds.h"

namespace slicefarm::coordinator {
namespace {

prometheus::Histogram& OfStage(prometheus::Registry& registry, const char* stage) {
  static const prometheus::Histogram::BucketBoundaries kBuckets = {
      0.01, 0.05, 0.1, 0.25, 0.5, 1, 2.5, 5, 10, 30, 60, 300, 1800};
  return prometheus::BuildHistogram()
      .Name("slicefarm_stage_seconds")
      .Help("What a stage took for a job, summed over its ranges, as its caller sees it")
      .Register(registry)
      .Add({{"stage", stage}}, kBuckets);
}

}  // namespace

StageSeconds::StageSeconds(prometheus::Registry& registry) {
  for (const auto& [stage, time] :
       {std::pair("slicing", &StageTimes::slicing_s), std::pair("planning", &StageTimes::planning_s),
        std::pair("beading", &StageTimes::beading_s), std::pair("infill", &StageTimes::infill_s),
        std::pair("ordering", &StageTimes::ordering_s), std::pair("motion", &StageTimes::motion_s),
        std::pair("exposure", &StageTimes::exposure_s)})
    stages_.emplace_back(time, &OfStage(registry, stage));
}

void StageSeconds::Observe(const StageTimes& times) {
  for (const auto& [time, histogram] : stages_)
    if (times.*time > 0) histogram->Observe(times.*time);
}

}  // namespace slicefarm::coordinator
