#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "common/base/error.h"
#include "common/rpc/client/duplex_call.h"
#include "common/stage/exposure_job.h"
#include "common/stage/motion_job.h"
#include "common/stage/object_layers.h"
#include "common/stage/ordering_job.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/plan_start_wire.h"
#include "common/wire/start_wire.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/layer_chain.h"
#include "processes/laser/task/laser_chain.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/exposure/algo/local_exposure_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/planning/algo/local_planning_stage.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/slicing/algo/placement/local_arranging_stage.h"
#include "slicefarm/v1/planning.grpc.pb.h"
#include "tests/integration/fake_stages.h"
#include "tests/integration/remote_clients.h"
#include "tests/integration/stage_host.h"
#include "tests/integration/whole_job.h"

namespace slicefarm::local_and_remote_test {
namespace {

/// Compares the stages in this process with the same stages behind a socket.
class LocalAndRemote : public testing::Test {
 protected:
  LocalAndRemote() {
    auto job = slicing_->Slice(call_, TextBox(), settings_.slicing);
    EXPECT_TRUE(job.ok()) << job.status();
    job_ = *std::move(job);
    auto plan = planning_->Plan(call_, {job_.layers, job_.copies}, PlanningOf(FdmOf(settings_)));
    EXPECT_TRUE(plan.ok()) << plan.status();
    plan_ = *std::move(plan);
    EXPECT_GT(LayerCount(), 20);
    facts_ = {LayerCount(), {}, {}};
    task_ = TaskOf({0, LayerCount()});
  }

  int32_t LayerCount() const { return static_cast<int32_t>(job_.layers.size()); }

  FdmTask TaskOf(LayerRange range) const {
    const LayerRange halo = WithHalo(job_.layers, range, HaloLayers(FdmOf(settings_)));
    return {range, std::span(job_.layers).subspan(halo.first, halo.size()),
            std::span(plan_.layers).subspan(range.first, range.size()),
            FdmShared{FdmOf(settings_), plan_.copies, facts_}};
  }

  const std::unique_ptr<SlicingStage> slicing_ = slicing::MakeLocalSlicing();
  const std::unique_ptr<PlanningStage> planning_ = planning::MakeLocalPlanning();
  const std::unique_ptr<BeadingStage> beading_ = beading::MakeLocalBeading();
  const std::unique_ptr<InfillStage> infill_ = infill::MakeLocalInfill();
  const std::unique_ptr<OrderingStage> ordering_ = ordering::MakeLocalOrdering();
  const std::unique_ptr<MotionStage> motion_ = motion::MakeLocalMotion();
  HostedStages Hosted() const {
    HostedStages hosted{*slicing_, *beading_, *infill_, *ordering_, *motion_, both_};
    hosted.exposure = exposure_.get();
    return hosted;
  }

  const std::unique_ptr<ExposureStage> exposure_ = exposure::MakeLocalExposure();
  const std::shared_ptr<const LayerChain> fdm_chain_ =
      std::make_shared<LayerChain>(*beading_, *infill_, *ordering_, *motion_);
  const std::shared_ptr<const LaserChain> laser_chain_ = std::make_shared<LaserChain>(*exposure_);
  const LayerChain& chain_ = *fdm_chain_;
  const LaserChain& laser_ = *laser_chain_;
  const ProcessRunners both_{{fdm_chain_, laser_chain_}};
  StageHost host_{Hosted()};
  const RemoteClients remote_{host_.Address()};
  const StageCall call_;
  JobSettings settings_;
  SlicedJob job_;
  JobPlan plan_;
  JobFacts facts_;
  FdmTask task_;
};

TEST_F(LocalAndRemote, EachStageGivesTheSame) {
  const auto remote_job = remote_.slicing.Slice(call_, TextBox(), settings_.slicing);
  ASSERT_TRUE(remote_job.ok()) << remote_job.status();
  EXPECT_EQ(remote_job->layers, job_.layers);
  EXPECT_EQ(remote_job->meshes, job_.meshes);
  EXPECT_EQ(remote_job->object_names, job_.object_names);
  EXPECT_EQ(remote_job->copies, job_.copies);
  EXPECT_EQ(remote_job->thumbnails, job_.thumbnails);

  const SlicedOutlines outlines{job_.layers, job_.copies};
  const auto remote_plan = remote_.planning.Plan(call_, outlines, PlanningOf(FdmOf(settings_)));
  ASSERT_TRUE(remote_plan.ok()) << remote_plan.status();
  EXPECT_EQ(*remote_plan, plan_);

  const Neighbourhood all{task_.range, task_.layers};
  const auto walled = beading_->Bead(call_, all, BeadingOf(FdmOf(settings_)));
  ASSERT_TRUE(walled.ok()) << walled.status();
  EXPECT_EQ(*remote_.beading.Bead(call_, all, BeadingOf(FdmOf(settings_))), *walled);

  const auto filled = infill_->Fill(call_, *walled, all, task_.plans, InfillOf(FdmOf(settings_)));
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(*remote_.infill.Fill(call_, *walled, all, task_.plans, InfillOf(FdmOf(settings_))),
            *filled);

  const auto order = [&](const OrderingStage& stage) {
    return stage.Order(call_, *filled, plan_.layers,
                       OrderingJob{OrderingOf(FdmOf(settings_)), plan_.copies});
  };
  const auto ordered = order(*ordering_);
  ASSERT_TRUE(ordered.ok()) << ordered.status();
  EXPECT_EQ(*order(remote_.ordering), *ordered);

  const MotionJob motion_job{MotionOf(FdmOf(settings_)), facts_};
  const auto programs = motion_->Program(call_, *ordered, motion_job);
  ASSERT_TRUE(programs.ok()) << programs.status();
  EXPECT_EQ(*remote_.motion.Program(call_, *ordered, motion_job), *programs);
}

// The service plans layers as they arrive, so their number is not known before.
TEST_F(LocalAndRemote, PlanningRefusesTheSameHereAndThere) {
  const auto refusals = [&](const SlicedOutlines& outlines, const PlanningOptions& options) {
    const absl::Status here = planning_->Plan(call_, outlines, options).status();
    const absl::Status there = remote_.planning.Plan(call_, outlines, options).status();
    EXPECT_EQ(DetailOf(here).reason, Reason::kRequestMalformed) << here;
    EXPECT_EQ(DetailOf(there).reason, Reason::kRequestMalformed) << there;
  };
  std::vector<PlacedCopy> copies = job_.copies;
  copies.push_back({.object = 1, .shift = {}, .footprint = {}});
  refusals({job_.layers, copies}, PlanningOf(FdmOf(settings_)));
  std::vector<SlicedLayer> layers = job_.layers;
  layers[7].sections[0].stack = 1;
  refusals({layers, job_.copies}, PlanningOf(FdmOf(settings_)));
}

TEST_F(LocalAndRemote, PlanningRefusesLayersThatDoNotFollowEachOther) {
  const SlicedOutlines without_first{std::span(job_.layers).subspan(1), job_.copies};
  const absl::Status status =
      remote_.planning.Plan(call_, without_first, PlanningOf(FdmOf(settings_))).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(status).metadata["field"], "message[0].layer");
}

/// Returns many islands on each layer, so that both streams are longer than gRPC's buffers.
std::vector<SlicedLayer> ManyIslands(int32_t layers) {
  MultiPolygon islands;
  for (Coord i = 0; i < 60; ++i) {
    const Point at{FromMm(i), 0};
    const Coord side = FromMm(0.5);
    islands.push_back({{at, at + Point{side, 0}, at + Point{side, side}, at + Point{0, side}}, {}});
  }
  std::vector<SlicedLayer> all;
  for (int32_t i = 0; i < layers; ++i) {
    ObjectSection section{0, i, layers, 200'000, {{Role::kPart, 0, 0, islands}}, {}, 0, {}};
    all.push_back({{i, (i + 1) * Coord{200'000}, 200'000}, {std::move(section)}});
  }
  return all;
}

TEST_F(LocalAndRemote, PlansOfManyLayersAreTheSameHereAndThere) {
  const std::vector<SlicedLayer> layers = ManyIslands(4'000);
  const SlicedOutlines outlines{layers, job_.copies};
  const auto here = planning_->Plan(call_, outlines, PlanningOf(FdmOf(settings_)));
  const auto there = remote_.planning.Plan(call_, outlines, PlanningOf(FdmOf(settings_)));
  ASSERT_TRUE(here.ok() && there.ok()) << there.status();
  EXPECT_EQ(*there, *here);
}

TEST_F(LocalAndRemote, PlansComeWhileLayersAreSent) {
  const std::vector<SlicedLayer> layers = ManyIslands(4'000);
  size_t plans = 0;
  rpc::DuplexCall<v1::PlanRequest, v1::PlanResponse> call(
      {},
      [&](auto* context, auto* queue) {
        return v1::Planning::Stub(remote_.replica.channel()).PrepareAsyncPlanJob(context, queue);
      },
      [&](const v1::PlanResponse& response) {
        plans += response.has_layer();
        return absl::OkStatus();
      });
  PlanningOptions options = PlanningOf(FdmOf(settings_));
  for (ObjectPlanOptions& object : options.objects) object.seam = SeamPosition::kNearest;
  v1::PlanRequest request;
  ASSERT_TRUE(ToProto(PlanStart{call_, options, job_.copies, {}}, request.mutable_start()).ok());
  ASSERT_TRUE(call.Write(request));
  for (const SlicedLayer& layer : layers) {
    ASSERT_TRUE(ToProto(layer, request.mutable_layer()).ok());
    ASSERT_TRUE(call.Write(request));
    request.Clear();
  }
  EXPECT_GT(plans, 0u) << "before the server can know that this was all";
  const absl::Status end = call.Finish();
  EXPECT_TRUE(end.ok()) << end;
  EXPECT_EQ(plans, layers.size());
}

TEST_F(LocalAndRemote, PlatesAreTheSameHereAndThere) {
  SliceInput input = TextBox();
  input.objects[0].copies.assign(30, {});
  SlicingOptions options = settings_.slicing;
  const auto mm = [](double x, double y) { return Point{FromMm(x), FromMm(y)}; };
  options.bed = {mm(0, 0), mm(250, 0), mm(250, 210), mm(0, 210)};
  const auto arranging = slicing::MakeLocalArranging();
  const auto here = arranging->PutOnPlates(call_, input, options);
  ASSERT_TRUE(here.ok()) << here.status();
  ASSERT_EQ(here->size(), 30);
  EXPECT_TRUE(std::ranges::any_of(*here, [](const PlatePosition& at) { return at.plate > 0; }));
  const auto there = remote_.arranging.PutOnPlates(call_, input, options);
  ASSERT_TRUE(there.ok()) << there.status();
  EXPECT_EQ(*there, *here);
  options.bed = {mm(0, 0), mm(1, 0), mm(1, 1), mm(0, 1)};
  EXPECT_EQ(DetailOf(remote_.arranging.PutOnPlates(call_, input, options).status()).reason,
            Reason::kOutOfBuildVolume);
}

TEST_F(LocalAndRemote, PlanningStopsWhenItIsCancelled) {
  StageCall call;
  call.cancel = CancelToken([] { return true; });
  const SlicedOutlines outlines{job_.layers, job_.copies};
  EXPECT_TRUE(
      absl::IsCancelled(planning_->Plan(call, outlines, PlanningOf(FdmOf(settings_))).status()));
  EXPECT_TRUE(absl::IsCancelled(
      remote_.planning.Plan(call, outlines, PlanningOf(FdmOf(settings_))).status()));
}

TEST_F(LocalAndRemote, AWorkerGivesWhatTheChainGives) {
  const auto local = chain_.Run(call_, task_);
  ASSERT_TRUE(local.ok()) << local.status();
  const auto remote = RunFdm(remote_.worker, call_, task_);
  ASSERT_TRUE(remote.ok()) << remote.status();
  EXPECT_EQ(remote->programs, local->programs);
  EXPECT_EQ(remote->warnings, local->warnings);
  EXPECT_EQ(remote->fills, local->fills);
  EXPECT_FALSE(local->fills.empty());
  EXPECT_GT(remote->times[Stage::kBeading], 0);
}

// A field by the distance to the surface needs the halo.
TEST_F(LocalAndRemote, FieldsGiveTheSameHereAndThereAndInRanges) {
  InfillOptions& infill = FdmOf(settings_).regions[0].infill;
  infill.density_field = R"({"kind":"surface_distance","near":0.6,"far":0.1,"length":1.5})";
  infill.field_halo_layers = 8;
  FdmOf(settings_).machine.motion.material_field =
      R"({"parts":[{"kind":"height","table":[[0,0],[9,1]]},{"kind":"height","table":[[0,1],[9,0]]}]})";
  const FdmTask by_distance = TaskOf(task_.range);
  const auto whole = chain_.Run(call_, by_distance);
  ASSERT_TRUE(whole.ok()) << whole.status();
  const auto remote = RunFdm(remote_.worker, call_, by_distance);
  ASSERT_TRUE(remote.ok()) << remote.status();
  EXPECT_EQ(remote->programs, whole->programs);
  infill.density_field.clear();
  infill.stress_field = R"({"kind":"constant","stress":[1,0,0.5]})";
  const LayerRange some{7, 11};
  const auto all = chain_.Run(call_, TaskOf(task_.range));
  const auto part = RunFdm(remote_.worker, call_, TaskOf(some));
  ASSERT_TRUE(all.ok()) << all.status();
  ASSERT_TRUE(part.ok()) << part.status();
  for (int32_t i = some.first; i < some.last; ++i)
    EXPECT_EQ(part->programs[static_cast<size_t>(i - some.first)],
              all->programs[static_cast<size_t>(i)]);
  EXPECT_NE(all->programs, whole->programs);
}

TEST_F(LocalAndRemote, ARangeWithoutAllTheLayersAroundItIsRefused) {
  FdmTask task = TaskOf({10, 12});
  const std::span<const SlicedLayer> all = task.layers;
  for (const auto& some : {all.subspan(1), all.first(all.size() - 1), all.subspan(all.size())}) {
    task.layers = some;
    EXPECT_EQ(DetailOf(chain_.Run(call_, task).status()).reason, Reason::kRequestMalformed);
    EXPECT_EQ(DetailOf(RunFdm(remote_.worker, call_, task).status()).reason,
              Reason::kRequestMalformed);
  }
}

TEST_F(LocalAndRemote, RangesGiveWhatTheWholeGives) {
  const auto whole = chain_.Run(call_, task_);
  ASSERT_TRUE(whole.ok()) << whole.status();
  for (const int32_t size : {1, 7, 20}) {
    std::vector<LayerProgram> programs;
    std::vector<FillStats> fills;
    for (int32_t first = 0; first < LayerCount(); first += size) {
      const auto part =
          RunFdm(remote_.worker, call_, TaskOf({first, std::min(first + size, LayerCount())}));
      ASSERT_TRUE(part.ok()) << part.status();
      programs.insert(programs.end(), part->programs.begin(), part->programs.end());
      fills.insert(fills.end(), part->fills.begin(), part->fills.end());
    }
    EXPECT_EQ(programs, whole->programs) << "ranges of " << size;
    EXPECT_EQ(fills, whole->fills) << "ranges of " << size;
  }
}

absl::StatusOr<LaserResult> RunLaser(const TaskRunner& worker, const StageCall& call,
                                     const LaserTask& task) {
  absl::StatusOr<TaskResult> result = worker.RunTask(call, task);
  if (!result.ok()) return result.status();
  return std::move(result->As<LaserResult>());
}

/// Scans the same outlines.
class LaserLocalAndRemote : public LocalAndRemote {
 protected:
  LaserLocalAndRemote() {
    exposure_settings_.regions[0].downskin_layers = 2;
    exposure_settings_.regions[0].strategy = ScanStrategy::kIslands;
  }

  LaserTask LaserTaskOf(LayerRange range) const {
    const LayerRange halo = WithHalo(job_.layers, range, HaloLayers(exposure_settings_));
    return {range, std::span(job_.layers).subspan(halo.first, halo.size()),
            ExposureJob{exposure_settings_, plan_.copies}};
  }

  ExposureSettings exposure_settings_;
};

TEST_F(LaserLocalAndRemote, RangesElsewhereGiveWhatTheWholeGivesHere) {
  const auto whole = laser_.Run(call_, LaserTaskOf({0, LayerCount()}));
  ASSERT_TRUE(whole.ok()) << whole.status();
  EXPECT_EQ(std::ssize(whole->programs), LayerCount());
  for (const int32_t size : {1, 7, LayerCount()}) {
    std::vector<ExposedProgram> programs;
    std::vector<ExposedProgram> by_stage;
    for (int32_t first = 0; first < LayerCount(); first += size) {
      const LaserTask task = LaserTaskOf({first, std::min(first + size, LayerCount())});
      const auto part = RunLaser(remote_.worker, call_, task);
      ASSERT_TRUE(part.ok()) << part.status();
      programs.insert(programs.end(), part->programs.begin(), part->programs.end());
      const auto staged = LaserChain(remote_.exposure).Run(call_, task);
      ASSERT_TRUE(staged.ok()) << staged.status();
      by_stage.insert(by_stage.end(), staged->programs.begin(), staged->programs.end());
    }
    EXPECT_EQ(programs, whole->programs) << "ranges of " << size;
    EXPECT_EQ(by_stage, whole->programs) << "ranges of " << size;
  }
}

TEST_F(LaserLocalAndRemote, FramesAreTheSame) {
  ExposureSummary summary;
  for (const SlicedLayer& layer : job_.layers) summary.layers.push_back(layer.frame);
  summary.bounds = {{0, 0}, {9, 9}};
  summary.object_names = {"textbox"};
  summary.settings_text = "recoating_time = 3\n";
  exposure_settings_.output.format = OutputFormat::kMarlin;
  exposure_settings_.output.layer_gcode = "M100 L{layer_num} P[recoating_time]";
  const auto here = exposure_->Envelope(call_, summary, exposure_settings_);
  const auto there = remote_.exposure.Envelope(call_, summary, exposure_settings_);
  ASSERT_TRUE(here.ok()) << here.status();
  ASSERT_TRUE(there.ok()) << there.status();
  EXPECT_EQ(*there, *here);
}

TEST_F(LaserLocalAndRemote, RefusesTheSameHereAndThere) {
  LaserTask task = LaserTaskOf({10, 12});
  task.layers = task.layers.subspan(1);
  EXPECT_EQ(DetailOf(laser_.Run(call_, task).status()).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(RunLaser(remote_.worker, call_, task).status()).reason,
            Reason::kRequestMalformed);
}

/// Two text boxes, one after the other.
class OneAfterTheOther : public LocalAndRemote {
 protected:
  OneAfterTheOther() {
    FdmOf(settings_).machine.plan.sequence.complete_objects = true;
    job_.copies.push_back(job_.copies[0]);
    PlacedCopy& second = job_.copies[1];
    second.shift = second.shift + kAway;
    for (Point& corner : second.footprint) corner = corner + kAway;
  }

  SlicedOutlines Outlines() const { return {job_.layers, job_.copies, job_.object_names}; }

  static constexpr Point kAway{0, 100 * kNmPerMm};
};

TEST_F(OneAfterTheOther, ThePlanIsTheSameHereAndThere) {
  const auto here = planning_->Plan(call_, Outlines(), PlanningOf(FdmOf(settings_)));
  const auto there = remote_.planning.Plan(call_, Outlines(), PlanningOf(FdmOf(settings_)));
  ASSERT_TRUE(here.ok()) << here.status();
  ASSERT_TRUE(there.ok()) << there.status();
  EXPECT_EQ(here->copies[0].pass + here->copies[1].pass, 1);
  EXPECT_EQ(*there, *here);
}

TEST_F(OneAfterTheOther, TheNamesOfWhatCollidesAreTheSameHereAndThere) {
  job_.copies[1] = job_.copies[0];
  const absl::Status here =
      planning_->Plan(call_, Outlines(), PlanningOf(FdmOf(settings_))).status();
  const absl::Status there =
      remote_.planning.Plan(call_, Outlines(), PlanningOf(FdmOf(settings_))).status();
  EXPECT_EQ(DetailOf(here).reason, Reason::kObjectsCollide) << here;
  EXPECT_EQ(DetailOf(here).metadata.at("first"), job_.object_names[0] + " (copy 1)");
  EXPECT_EQ(DetailOf(there).reason, Reason::kObjectsCollide) << there;
  EXPECT_EQ(DetailOf(there).metadata.at("first"), job_.object_names[0] + " (copy 1)");
}

TEST_F(OneAfterTheOther, RangesElsewhereGiveWhatTheWholeGivesHere) {
  plan_ = *planning_->Plan(call_, Outlines(), PlanningOf(FdmOf(settings_)));
  FdmOf(settings_).machine.motion.layer_gcode =
      ";{layer_num} of {total_layer_count}, {max_layer_z}";
  facts_ = {2 * LayerCount(), {}, {{}, {LayerCount(), 0, 5'000'000}}};
  const auto whole = chain_.Run(call_, TaskOf({0, LayerCount()}));
  ASSERT_TRUE(whole.ok()) << whole.status();
  EXPECT_EQ(std::ssize(whole->programs), 2 * LayerCount());
  for (const int32_t size : {1, 20}) {
    std::vector<LayerProgram> programs;
    for (int32_t first = 0; first < LayerCount(); first += size) {
      const auto part =
          RunFdm(remote_.worker, call_, TaskOf({first, std::min(first + size, LayerCount())}));
      ASSERT_TRUE(part.ok()) << part.status();
      programs.insert(programs.end(), part->programs.begin(), part->programs.end());
    }
    EXPECT_EQ(programs, whole->programs) << "ranges of " << size;
  }
}

}  // namespace
}  // namespace slicefarm::local_and_remote_test
