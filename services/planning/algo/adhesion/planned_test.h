#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "common/model/options/planning_options.h"
#include "common/stage/print_layers.h"
#include "common/stage/slicing_stage.h"
#include "services/planning/algo/job_planner.h"
#include "services/planning/algo/layers_test.h"

namespace slicefarm::planning {

/// A plan together with the layers of its print.
struct Planned {
  JobPlan plan;
  std::vector<SlicedLayer> print;
};

/// Returns all regions of a role in a layer.
inline MultiPolygon RegionsOf(const Planned& planned, size_t layer, Role role) {
  MultiPolygon all;
  for (const ObjectSection& section : planned.print[layer].sections)
    for (const Region& region : section.regions)
      if (region.role == role)
        all.insert(all.end(), region.outlines.begin(), region.outlines.end());
  return all;
}

inline absl::StatusOr<Planned> Plan(const PlanningOptions& options,
                                    const std::vector<PlacedCopy>& copies,
                                    const std::vector<SlicedLayer>& parts) {
  auto planner = JobPlanner::Make(options, copies);
  if (!planner.ok()) return planner.status();
  for (const SlicedLayer& layer : parts)
    if (absl::Status ok = planner->Next(layer); !ok.ok()) return ok;
  auto plan = planner->Finish();
  if (!plan.ok()) return plan.status();
  auto print = PrintLayers(parts, plan->lifts_nm, plan->stacks);
  EXPECT_EQ(print.size(), plan->layers.size());
  return Planned{*std::move(plan), std::move(print)};
}

inline Planned PlanOrDie(const PlanningOptions& options, const std::vector<PlacedCopy>& copies,
                         const std::vector<SlicedLayer>& parts) {
  auto plan = Plan(options, copies, parts);
  EXPECT_TRUE(plan.ok()) << plan.status();
  return plan.ok() ? *std::move(plan) : Planned{};
}

/// Returns options of an object on a raft. The raft's rows of settings begin at 10.
inline ObjectPlanOptions OnRaft(int32_t layers) {
  ObjectPlanOptions object;
  object.raft.heights.layers = layers;
  for (int32_t i = 0; i < layers; ++i) object.raft_settings.push_back(10 + i);
  return object;
}

/// Returns two layers of 0.2 mm. On a raft of two layers (0.2 and 0.3 mm) and a gap of 0.1 mm they
/// end at 0.8 and 1.0 mm.
inline std::vector<SlicedLayer> TwoLayers() {
  return LayersOrDie({"(-5 -5, 5 -5, 5 5, -5 5)", "(-5 -5, 5 -5, 5 5, -5 5)"});
}

}  // namespace slicefarm::planning
