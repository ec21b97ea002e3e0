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

StageSeconds::StageSeconds(prometheus::Registry& registry)
    : slicing_(OfStage(registry, "slicing")),
      beading_(OfStage(registry, "beading")),
      infill_(OfStage(registry, "infill")),
      ordering_(OfStage(registry, "ordering")),
      motion_(OfStage(registry, "motion")) {}

void StageSeconds::Observe(const StageTimes& times) {
  slicing_.Observe(times.slicing_s);
  beading_.Observe(times.beading_s);
  infill_.Observe(times.infill_s);
  ordering_.Observe(times.ordering_s);
  motion_.Observe(times.motion_s);
}

}  // namespace slicefarm::coordinator
