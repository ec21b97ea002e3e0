#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "processes/mill/job/mill_scene.h"
#include "processes/mill/job/step_split.h"
#include "processes/mill/task/mill_chain.h"
#include "services/milling/algo/local_milling_stage.h"
#include "services/slicing/algo/placement/local_placing_stage.h"
#include "tests/integration/fake_stages.h"
#include "tests/integration/remote_clients.h"
#include "tests/integration/stage_host.h"
#include "tests/integration/whole_job.h"

namespace slicefarm::mill_local_and_remote_test {
namespace {

/// Compares placing and milling in this program with the same behind a socket, and with a worker
/// that mills.
class MillLocalAndRemote : public testing::Test {
 protected:
  MillLocalAndRemote() {
    auto scene = placing_->Place(call_, TextBox(), SlicingOptions());
    EXPECT_TRUE(scene.ok()) << scene.status();
    placed_ = *std::move(scene);
    MillSettings settings;
    settings.how.cutter = *Cutter::Cylinder(3);
    settings.how.stepdown_mm = 2;
    settings.how.finish_stepdown_mm = 1;
    settings.how.finish_stepover_mm = 1;
    auto input = coordinator::MillSceneOf(placed_, std::nullopt, settings);
    EXPECT_TRUE(input.ok()) << input.status();
    input_ = std::move(input->input);
    auto layout = milling_->LayOut(call_, input_);
    EXPECT_TRUE(layout.ok()) << layout.status();
    layout_ = *std::move(layout);
  }

  HostedStages Hosted() const {
    HostedStages hosted{fakes_.slicing,  fakes_.beading, fakes_.infill,
                        fakes_.ordering, fakes_.motion,  chain_};
    hosted.milling = milling_.get();
    return hosted;
  }

  /// Computes all steps with `run`, in ranges for this number of slots.
  template <class Run>
  std::vector<MilledStep> AllSteps(int slots, const Run& run) const {
    std::vector<MilledStep> steps;
    for (const MillTask& task : coordinator::SplitSteps(layout_, input_, slots)) {
      absl::StatusOr<std::vector<MilledStep>> made = run(task);
      EXPECT_TRUE(made.ok()) << made.status();
      if (made.ok()) std::ranges::move(*made, std::back_inserter(steps));
    }
    return steps;
  }

  struct Fakes {
    FakeStages fakes;
    FakeSlicing slicing{fakes};
    FakeBeading beading{fakes};
    FakeInfill infill{fakes};
    FakeOrdering ordering{fakes};
    FakeMotion motion{fakes};
  } fakes_;
  const std::unique_ptr<PlacingStage> placing_ = slicing::MakeLocalPlacing();
  const std::unique_ptr<MillingStage> milling_ = milling::MakeLocalMilling();
  const MillChain chain_{*milling_};
  StageHost host_{Hosted()};
  const RemoteClients remote_{host_.Address()};
  const StageCall call_;
  PlacedScene placed_;
  Shared<MillInput> input_;
  MillLayout layout_;
};

TEST_F(MillLocalAndRemote, ScenesAreTheSame) {
  const auto there = remote_.placing.Place(call_, TextBox(), SlicingOptions());
  ASSERT_TRUE(there.ok()) << there.status();
  ASSERT_EQ(there->objects.size(), placed_.objects.size());
  EXPECT_EQ(there->objects[0].shifts, placed_.objects[0].shifts);
  EXPECT_EQ(there->objects[0].to_origin, placed_.objects[0].to_origin);
  ASSERT_EQ(there->objects[0].parts.size(), placed_.objects[0].parts.size());
  EXPECT_EQ(there->objects[0].parts[0].mesh, placed_.objects[0].parts[0].mesh);
  EXPECT_EQ(there->objects[0].parts[0].report, placed_.objects[0].parts[0].report);
}

TEST_F(MillLocalAndRemote, ABlankIsPlacedWithoutATableThereToo) {
  const std::string blank = "blank";
  SliceInput parts = TextBox();
  parts.objects.push_back(parts.objects.front());
  parts.objects.back().name = blank;
  SlicingOptions options;
  options.objects.resize(parts.objects.size());
  auto split = coordinator::TakeStock({std::move(parts), options}, blank);
  ASSERT_TRUE(split.ok()) << split.status();
  coordinator::PutAround(placed_, *split->stock);
  const auto here = placing_->Place(call_, split->stock->meshes, split->stock->options);
  const auto there = remote_.placing.Place(call_, split->stock->meshes, split->stock->options);
  ASSERT_TRUE(here.ok()) << here.status();
  ASSERT_TRUE(there.ok()) << there.status();
  EXPECT_EQ(there->objects.at(0).shifts, here->objects.at(0).shifts);
}

TEST_F(MillLocalAndRemote, RangesElsewhereGiveTheSameProgram) {
  const auto layout = remote_.milling.LayOut(call_, input_);
  ASSERT_TRUE(layout.ok()) << layout.status();
  EXPECT_EQ(layout->steps, layout_.steps);
  EXPECT_EQ(layout->weights, layout_.weights);
  const auto here =
      AllSteps(1, [&](const MillTask& task) { return milling_->Mill(call_, input_, task.steps); });
  const auto whole = milling_->Assemble(call_, input_, here, "stepdown = 2\n");
  ASSERT_TRUE(whole.ok()) << whole.status();
  EXPECT_EQ(whole->report.gouges, 0);
  for (const int slots : {2, 7}) {
    const auto staged = AllSteps(slots, [&](const MillTask& task) {
      return remote_.milling.Mill(call_, input_, task.steps);
    });
    EXPECT_EQ(staged, here) << slots;
    const auto worked = AllSteps(slots, [&](const MillTask& task) {
      absl::StatusOr<TaskResult> result = remote_.worker.RunTask(call_, task);
      if (!result.ok()) return absl::StatusOr<std::vector<MilledStep>>(result.status());
      return absl::StatusOr<std::vector<MilledStep>>(result->As<MillResult>().steps);
    });
    EXPECT_EQ(worked, here) << slots;
  }
  const auto there = remote_.milling.Assemble(call_, input_, here, "stepdown = 2\n");
  ASSERT_TRUE(there.ok()) << there.status();
  EXPECT_EQ(there->text, whole->text);
  EXPECT_EQ(there->report, whole->report);
  EXPECT_EQ(host_.shared().counts().entries, 1) << "the input was sent once";
}

TEST_F(MillLocalAndRemote, RefusesTheSameHereAndThere) {
  MillInput wide = *input_;
  wide.settings.how.cutter = *Cutter::Cylinder(500);
  const absl::Status here = milling_->LayOut(call_, wide).status();
  const absl::Status there = remote_.milling.LayOut(call_, wide).status();
  EXPECT_EQ(there.message(), here.message());
  EXPECT_EQ(DetailOf(there).metadata["setting"], "cutter");
  EXPECT_EQ(DetailOf(remote_.milling.Mill(call_, input_, {0, 100'000}).status()).reason,
            Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::mill_local_and_remote_test
