#include <cstdlib>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/stage/print_layers.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/plan_start_wire.h"
#include "common/wire/start_wire.h"
#include "services/planning/algo/local_planning_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

/// Returns true if the plan fits the layer: it has as many seams as the section has rings.
bool Fits(const SectionPlan& plan, const SlicedLayer& layer) {
  for (const ObjectSection& section : layer.sections) {
    if (section.stack.id != plan.stack) continue;
    return plan.seams.empty() || plan.seams.size() == Rings(OutlineOf(section)).size();
  }
  return false;
}

void Check(const JobPlan& plan, const PlanStart& start, std::vector<SlicedLayer> parts) {
  const std::vector<SlicedLayer> layers = PrintLayers(std::move(parts), plan.lifts_nm, plan.stacks);
  if (plan.layers.size() != layers.size() || plan.copies.size() != start.copies.size()) {
    std::abort();
  }
  for (size_t i = 0; i < layers.size(); ++i) {
    CheckRoundTrip(Encoded<v1::LayerPlan>(plan.layers[i]));
    for (const SectionPlan& section : plan.layers[i].sections)
      if (!Fits(section, layers[i])) std::abort();
  }
  for (const Copy& copy : plan.copies) CheckRoundTrip(Encoded<v1::Copy>(copy));
  for (const AddedStack& added : plan.stacks)
    for (const ObjectSection& section : added.sections)
      CheckRoundTrip(Encoded<v1::ObjectSection>(section));
  if (plan.skirt.layers > std::ssize(layers)) std::abort();
  CheckRoundTrip(Encoded<v1::Skirt>(plan.skirt));
}

void Run(const PlanCall& given) {
  static const auto stage = planning::MakeLocalPlanning();
  for (const v1::PlanRequest& request : given.requests()) {
    CheckRoundTrip(request.start());
    CheckRoundTrip(request.layer());
  }
  Requests<v1::PlanRequest> requests(given.requests());
  const auto start = ReadStart<v1::PlanRequest>(requests, WithDeadline());
  if (!start.ok()) return;
  std::vector<SlicedLayer> layers;
  const absl::Status read =
      ReadEach<v1::PlanRequest>(requests, [&](const v1::PlanRequest& request) {
        return AppendNext(FromProto(request.layer()), &layers);
      });
  if (!read.ok()) return;
  const auto plan = stage->Plan(start->call, {layers, start->copies}, start->options);
  if (plan.ok()) Check(*plan, *start, layers);
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::PlanCall, slicefarm::fuzz::Run)
