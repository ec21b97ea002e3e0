#include "services/coordinator/server/observe/stage_seconds.h"

#include <string>

namespace slicefarm::coordinator {
namespace {

prometheus::Histogram& OfStage(prometheus::Registry& registry, const std::string& stage) {
  static const prometheus::Histogram::BucketBoundaries kBuckets = {
      0.01, 0.05, 0.1, 0.25, 0.5, 1, 2.5, 5, 10, 30, 60, 300, 1800};
  return prometheus::BuildHistogram()
      .Name("slicefarm_stage_seconds")
      .Help(
          "Seconds that a stage took for a job, summed over its ranges, as measured by its caller")
      .Register(registry)
      .Add({{"stage", stage}}, kBuckets);
}

}  // namespace

StageSeconds::StageSeconds(prometheus::Registry& registry) {
  for (const StageInfo& info : kStages)
    stages_.emplace_back(info.stage, &OfStage(registry, std::string(info.name)));
}

void StageSeconds::Observe(const StageTimes& times) {
  for (const auto& [stage, histogram] : stages_)
    if (times[stage] > 0) histogram->Observe(times[stage]);
}

}  // namespace slicefarm::coordinator
