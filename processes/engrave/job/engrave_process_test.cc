#include "processes/engrave/job/engrave_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "common/base/error.h"
#include "processes/engrave/task/engrave_chain.h"
#include "processes/engrave/task/fake_texture_test.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"
#include "services/coordinator/algo/pipeline/preflight.h"

namespace slicefarm::coordinator::engrave_process_test {
namespace {

/// Placing stage that returns one triangle for each object.
class FakeSurfaces : public PlacingStage {
 public:
  absl::StatusOr<PlacedScene> Place(const StageCall&, SliceInput,
                                    const SlicingOptions&) const override {
    return PlacedScene();
  }
  absl::StatusOr<std::vector<SurfaceMesh>> ReadSurfaces(const StageCall&, SliceInput input,
                                                        const SlicingOptions&) const override {
    return std::vector<SurfaceMesh>(input.objects.size(),
                                    {{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{0, 1, 2}}});
  }
};

/// Slicing stage that must not be called: engraving does not slice surfaces with planes.
class NoSlicing : public SlicingStage {
 public:
  absl::StatusOr<SlicedJob> Slice(const StageCall&, SliceInput,
                                  const SlicingOptions&) const override {
    return absl::InternalError("a surface was sliced");
  }
};

class EngraveProcessTest : public testing::Test {
 protected:
  absl::StatusOr<JobOutput> Run(int slots, const std::vector<std::string>& objects = {"face"}) {
    Dispatcher dispatcher;
    dispatcher.Join({.name = "here", .tasks = chain_, .slots = slots});
    return Pipeline(dispatcher).Run({}, Input(objects), nullptr);
  }

  JobInput Input(const std::vector<std::string>& objects) const {
    JobInput input;
    input.settings.own = settings_;
    input.warnings = {"of the settings"};
    for (const std::string& name : objects)
      input.meshes.objects.push_back({.name = name, .parts = {{}}, .ranges = {}});
    return input;
  }

  JobPipeline Pipeline(Dispatcher& dispatcher) const {
    std::vector<std::unique_ptr<JobProcess>> processes;
    processes.push_back(std::make_unique<EngraveProcess>(placing_, texture_));
    return {std::move(processes), dispatcher};
  }

  EngraveSettings settings_;
  FakeSurfaces placing_;
  FakeTexture texture_;
  std::shared_ptr<EngraveChain> chain_ = std::make_shared<EngraveChain>(texture_);
};

TEST_F(EngraveProcessTest, PutsTheFileTogetherWhateverTheCut) {
  for (const int slots : {1, 2, 16}) {
    const auto output = Run(slots);
    ASSERT_TRUE(output.ok()) << output.status();
    EXPECT_EQ(*output->program.Whole(),
              "head\nlayer 0\nlayer 1\nlayer 2\nlayer 3\nlayer 4\nlayer 5\nlayer 6\nfoot\n");
  }
  settings_.texture.outside = true;
  const auto output = Run(2);
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_THAT(*output->program.Whole(), testing::StartsWith("head\nlayer 6\nlayer 5\n"));
}

TEST_F(EngraveProcessTest, ReportsWhatItCameTo) {
  const auto output = Run(2);
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_EQ(output->report.layer_count, 7);
  EXPECT_EQ(output->report.print_time_s, 21);
  EXPECT_THAT(output->report.warnings, testing::ElementsAre("of the settings"));
  EXPECT_EQ(output->report.meshes.size(), 1u);
  nlohmann::ordered_json json;
  output->report.own->AddTo(json);
  EXPECT_EQ(json["engraving"]["on_mm"], 14);
  EXPECT_EQ(json["engraving"]["map"]["faces"], 1);
}

/// A mesh or picture format has a single text and no toolpaths.
TEST_F(EngraveProcessTest, AWholeFileIsOnePiece) {
  settings_.format = EngraveFormat::kStl;
  settings_.texture.outside = true;
  for (const int slots : {1, 16}) {
    const auto output = Run(slots);
    ASSERT_TRUE(output.ok()) << output.status();
    EXPECT_EQ(*output->program.Whole(), "head\nwhole\nfoot\n");
    EXPECT_EQ(output->report.layer_count, 7);
    EXPECT_EQ(output->report.print_time_s, 0);
    EXPECT_THAT(output->report.warnings, testing::ElementsAre("of the settings"));
  }
  Dispatcher dispatcher;
  dispatcher.Join({.name = "here", .tasks = chain_, .slots = 2});
  const auto found = LookAt({}, Input({"face"}), NoSlicing(), Pipeline(dispatcher));
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_EQ(found->print_time_s, 0);
}

TEST_F(EngraveProcessTest, IsLookedAtWithoutSlicing) {
  Dispatcher dispatcher;
  const auto found = LookAt({}, Input({"face"}), NoSlicing(), Pipeline(dispatcher));
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_EQ(found->layers, FakeTexture::kLayers);
  EXPECT_EQ(found->first_layer_area_mm2, 0);
  EXPECT_THAT(found->warnings, testing::ElementsAre("of the settings"));
  ASSERT_EQ(found->meshes.size(), 1u);
  EXPECT_EQ(found->meshes[0].name, "face");
  EXPECT_EQ(found->meshes[0].triangles, 1);
  EXPECT_EQ(found->meshes[0].open_edges, 3);
  EXPECT_EQ(found->meshes[0].max_mm, (std::array<double, 3>{9, 9, 0}));
}

/// The estimate equals the time of the whole job.
TEST_F(EngraveProcessTest, TimeIsEstimatedByLayersThatAreMade) {
  Dispatcher dispatcher;
  dispatcher.Join({.name = "here", .tasks = chain_, .slots = 2});
  const auto found = LookAt({}, Input({"face"}), NoSlicing(), Pipeline(dispatcher));
  ASSERT_TRUE(found.ok()) << found.status();
  EXPECT_DOUBLE_EQ(found->print_time_s, 21);
}

TEST_F(EngraveProcessTest, AnObjectMayBeTheTexture) {
  EXPECT_EQ(DetailOf(Run(1, {"face", "leaf"}).status()).reason, Reason::kRequestMalformed);
  settings_.texture.texture = "leaf";
  EXPECT_TRUE(Run(1, {"face", "leaf"}).ok());
  EXPECT_TRUE(Run(1, {"leaf", "face"}).ok());
  EXPECT_FALSE(Run(1, {"leaf", "face", "hand"}).ok());
}

}  // namespace
}  // namespace slicefarm::coordinator::engrave_process_test
