#include <gtest/gtest.h>

#include <memory>

#include "common/base/error.h"
#include "common/stage/layer_chain.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/coordinator/algo/pipeline/layer_plan.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "tests/integration/remote_clients.h"
#include "tests/integration/stage_host.h"
#include "tests/integration/whole_job.h"

namespace slicefarm {
namespace {

/// The stages as they are, here and behind a socket.
class LocalAndRemote : public testing::Test {
 protected:
  LocalAndRemote() {
    auto job = slicing_->Slice(call_, TextBox(), settings_.slicing);
    EXPECT_TRUE(job.ok()) << job.status();
    job_ = *std::move(job);
    plans_ = *coordinator::PlanLayers(job_.layers, settings_.ordering.seam, {});
    const int32_t count = static_cast<int32_t>(job_.layers.size());
    EXPECT_GT(count, 20);
    task_ = TaskOf({0, count});
  }

  RangeTask TaskOf(LayerRange range) const {
    const auto count = static_cast<int32_t>(job_.layers.size());
    const LayerRange halo = range.Grown(HaloLayers(settings_), count);
    return {range, count, std::span(job_.layers).subspan(halo.first, halo.size()),
            std::span(plans_).subspan(range.first, range.size()), &settings_};
  }

  const std::unique_ptr<SlicingStage> slicing_ = slicing::MakeLocalSlicing();
  const std::unique_ptr<BeadingStage> beading_ = beading::MakeLocalBeading();
  const std::unique_ptr<InfillStage> infill_ = infill::MakeLocalInfill();
  const std::unique_ptr<OrderingStage> ordering_ = ordering::MakeLocalOrdering();
  const std::unique_ptr<MotionStage> motion_ = motion::MakeLocalMotion();
  const LayerChain chain_{*beading_, *infill_, *ordering_, *motion_};
  StageHost host_{{*slicing_, *beading_, *infill_, *ordering_, *motion_, chain_}};
  const RemoteClients remote_{host_.Address()};
  const StageCall call_;
  const JobSettings settings_;
  SlicedJob job_;
  std::vector<LayerPlan> plans_;
  RangeTask task_;
};

TEST_F(LocalAndRemote, EachStageGivesTheSame) {
  const auto remote_job = remote_.slicing.Slice(call_, TextBox(), settings_.slicing);
  ASSERT_TRUE(remote_job.ok()) << remote_job.status();
  EXPECT_EQ(remote_job->layers, job_.layers);
  EXPECT_EQ(remote_job->meshes, job_.meshes);
  EXPECT_EQ(remote_job->object_names, job_.object_names);
  EXPECT_EQ(remote_job->thumbnails, job_.thumbnails);

  const Neighbourhood all{task_.range, task_.layer_count, task_.layers};
  const auto walled = beading_->Bead(call_, all, settings_.beading);
  ASSERT_TRUE(walled.ok()) << walled.status();
  EXPECT_EQ(*remote_.beading.Bead(call_, all, settings_.beading), *walled);

  const auto filled = infill_->Fill(call_, *walled, all, settings_.infill);
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(*remote_.infill.Fill(call_, *walled, all, settings_.infill), *filled);

  const auto ordered = ordering_->Order(call_, *filled, plans_, settings_.ordering);
  ASSERT_TRUE(ordered.ok()) << ordered.status();
  EXPECT_EQ(*remote_.ordering.Order(call_, *filled, plans_, settings_.ordering), *ordered);

  const auto programs = motion_->Program(call_, *ordered, settings_.motion);
  ASSERT_TRUE(programs.ok()) << programs.status();
  EXPECT_EQ(*remote_.motion.Program(call_, *ordered, settings_.motion), *programs);
}

TEST_F(LocalAndRemote, AWorkerGivesWhatTheChainGives) {
  const auto local = chain_.Run(call_, task_);
  ASSERT_TRUE(local.ok()) << local.status();
  const auto remote = remote_.worker.Run(call_, task_);
  ASSERT_TRUE(remote.ok()) << remote.status();
  EXPECT_EQ(remote->programs, local->programs);
  EXPECT_GT(remote->times.beading_s, 0);
}

TEST_F(LocalAndRemote, ARangeWithoutAllTheLayersAroundItIsRefused) {
  RangeTask task = TaskOf({10, 12});
  const std::span<const SlicedLayer> all = task.layers;
  for (const auto& some : {all.subspan(1), all.first(all.size() - 1), all.subspan(all.size())}) {
    task.layers = some;
    EXPECT_EQ(DetailOf(chain_.Run(call_, task).status()).reason, Reason::kRequestMalformed);
    EXPECT_EQ(DetailOf(remote_.worker.Run(call_, task).status()).reason, Reason::kRequestMalformed);
  }
}

TEST_F(LocalAndRemote, RangesGiveWhatTheWholeGives) {
  const auto whole = chain_.Run(call_, task_);
  ASSERT_TRUE(whole.ok()) << whole.status();
  for (const int32_t size : {1, 7, 20}) {
    std::vector<LayerProgram> programs;
    for (int32_t first = 0; first < task_.layer_count; first += size) {
      const auto part =
          remote_.worker.Run(call_, TaskOf({first, std::min(first + size, task_.layer_count)}));
      ASSERT_TRUE(part.ok()) << part.status();
      programs.insert(programs.end(), part->programs.begin(), part->programs.end());
    }
    EXPECT_EQ(programs, whole->programs) << "ranges of " << size;
  }
}

}  // namespace
}  // namespace slicefarm
