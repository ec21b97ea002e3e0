#include "processes/mill/job/mill_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "common/base/error.h"
#include "processes/mill/job/mill_job_report.h"
#include "processes/mill/task/fake_milling_test.h"
#include "processes/mill/task/mill_chain.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"
#include "services/coordinator/algo/pipeline/report_json.h"

namespace slicefarm::coordinator::mill_process_test {
namespace {

/// Placing stage that returns an object with one triangle for each object of the input.
class FakePlacing : public PlacingStage {
 public:
  absl::StatusOr<PlacedScene> Place(const StageCall&, SliceInput input,
                                    const SlicingOptions&) const override {
    PlacedScene scene;
    for (const ObjectInput& object : input.objects) {
      PlacedSceneObject& placed = scene.objects.emplace_back();
      placed.name = object.name;
      placed.shifts = {object.copies.front().at};
      PlacedScenePart& part = placed.parts.emplace_back();
      part.mesh = {{{0, 0, 0}, {FromMm(9), 0, 0}, {0, FromMm(9), 0}}, {{0, 1, 2}}};
      part.report.name = object.name;
      part.report.flipped_faces = 1;
    }
    return scene;
  }
  absl::StatusOr<std::vector<SurfaceMesh>> ReadSurfaces(const StageCall&, SliceInput,
                                                        const SlicingOptions&) const override {
    return std::vector<SurfaceMesh>();
  }
};

class MillProcessTest : public testing::Test {
 protected:
  absl::StatusOr<JobOutput> Run(int slots = 2, int objects = 1) {
    Dispatcher dispatcher;
    dispatcher.Join({.name = "here", .tasks = chain_, .slots = slots});
    JobInput input;
    input.settings = settings_;
    input.settings.slicing.objects.resize(static_cast<size_t>(objects));
    input.settings_text = "stepdown = 1\n";
    input.warnings = {"of the settings"};
    input.meshes.files = {{"thing", MeshFormat::kStl, "bytes"}};
    for (int i = 0; i < objects; ++i)
      input.meshes.objects.push_back(
          {.name = i == 0 ? "thing" : "blank", .parts = {{}}, .ranges = {}});
    std::vector<std::unique_ptr<JobProcess>> processes;
    processes.push_back(std::make_unique<MillProcess>(placing_, milling_));
    return JobPipeline(std::move(processes), dispatcher).Run({}, std::move(input), nullptr);
  }

  JobSettings settings_ = {.slicing = {}, .own = MillSettings()};
  FakePlacing placing_;
  FakeMilling milling_;
  std::shared_ptr<MillChain> chain_ = std::make_shared<MillChain>(milling_);
};

constexpr char kProgram[] = "R10 R9 R8 R7 R6 F10 F9 F8 W10 W9 W8 W7 stepdown = 1\n";

TEST_F(MillProcessTest, PutsTheProgramTogether) {
  for (const int slots : {1, 2, 16}) {
    const auto output = Run(slots);
    ASSERT_TRUE(output.ok()) << output.status();
    EXPECT_EQ(*output->program.Whole(), kProgram) << slots;
  }
}

TEST_F(MillProcessTest, ReportsWhatItCameTo) {
  milling_.gouges = 2;
  const auto output = Run();
  ASSERT_TRUE(output.ok()) << output.status();
  const JobReport& report = output->report;
  EXPECT_EQ(report.layer_count, 8);
  EXPECT_EQ(report.print_time_s, 90);
  EXPECT_EQ(report.object_height_mm, 3);
  EXPECT_THAT(report.warnings,
              testing::ElementsAre("of the settings", testing::HasSubstr("wrong orientation"),
                                   testing::HasSubstr("cuts into the part at 2")));
  const auto json = nlohmann::json::parse(ReportJson(report, {}));
  EXPECT_EQ(json["milling"]["cutter"], "ball:4");
  EXPECT_EQ(json["milling"]["phases"]["roughing"]["steps"], 5);
  EXPECT_EQ(json["milling"]["removed_mm3"], 12);
  EXPECT_EQ(json["milling"]["gouge_check"]["gouges"], 2);
}

TEST_F(MillProcessTest, MakesOnlyTheStepOfAPicture) {
  MillOf(settings_).format = MillFormat::kSvg;
  MillOf(settings_).output_step = 6;
  const auto output = Run();
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_EQ(*output->program.Whole(), "F9 stepdown = 1\n");
}

TEST_F(MillProcessTest, HandsPartAndStockOn) {
  ASSERT_TRUE(Run(2, 2).ok());
  EXPECT_EQ(milling_.laid_out.part.triangles.size(), 2u);
  EXPECT_TRUE(milling_.laid_out.stock.triangles.empty());
  MillOf(settings_).stock = "blank";
  ASSERT_TRUE(Run(2, 2).ok());
  EXPECT_EQ(milling_.laid_out.part.triangles.size(), 1u);
  EXPECT_EQ(milling_.laid_out.stock.triangles.size(), 1u);
}

TEST_F(MillProcessTest, ErrorsEndTheJob) {
  milling_.lost = 3;
  EXPECT_EQ(DetailOf(Run().status()).reason, Reason::kInternal);
  milling_.lost = -1;
  milling_.fails = true;
  EXPECT_EQ(Run().status().message(), "milling");
  MillOf(settings_).stock = "nothing";
  EXPECT_EQ(DetailOf(Run().status()).metadata["setting"], "stock");
}

}  // namespace
}  // namespace slicefarm::coordinator::mill_process_test
