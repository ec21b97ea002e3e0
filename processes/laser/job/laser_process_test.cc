#include "processes/laser/job/laser_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/geometry/text_format_test.h"
#include "common/stage/exposure_job.h"
#include "processes/laser/job/laser_report.h"
#include "processes/laser/task/laser_chain.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"

namespace slicefarm::coordinator::laser_process_test {
namespace {

/// Slicing stage that returns a layer of 1 mm for each letter. An 'x' has an outline.
class FakeSlicing : public SlicingStage {
 public:
  absl::StatusOr<SlicedJob> Slice(const StageCall&, SliceInput input,
                                  const SlicingOptions&) const override {
    SlicedJob job;
    const std::string& bytes = input.files[0].bytes;
    for (size_t i = 0; i < bytes.size(); ++i) {
      SlicedLayer& layer = job.layers.emplace_back();
      layer.frame = {static_cast<int32_t>(i), FromMm(static_cast<double>(i) + 1), FromMm(1)};
      ObjectSection& section = layer.sections.emplace_back();
      section.layer = static_cast<int32_t>(i);
      section.layer_count = static_cast<int32_t>(bytes.size());
      if (bytes[i] == 'x')
        section.regions.push_back({.outlines = MakePolygonsOrDie("(0 0, 9 0, 0 9)")});
    }
    job.object_names = {"thing"};
    job.copies = {{0, {FromMm(5), 0}, {}}, {0, {FromMm(25), 0}, {}}};
    return job;
  }
};

/// Exposure stage that writes the number of the layer and its copies.
class FakeExposure : public ExposureStage {
 public:
  absl::StatusOr<std::vector<ExposedProgram>> Expose(
      const StageCall&, const Neighbourhood& hood, const Shared<ExposureJob>& job) const override {
    std::vector<ExposedProgram> programs;
    for (const SlicedLayer& layer : hood.layers) {
      const int32_t index = layer.frame.index;
      if (index < hood.range.first || index >= hood.range.last || index == lost) continue;
      ExposedProgram& program = programs.emplace_back();
      program.frame = layer.frame;
      program.text = absl::StrCat(index, "x", job->copies.size(), " ");
      if (layer.sections[0].regions.empty()) continue;
      program.report.kinds[0] = {4, dark ? 0 : 1, 10, 0.5, 100};
      program.report.jumps = 1;
      program.report.jump_mm = 20;
      program.report.jump_time_s = 0.25;
      program.report.volume_mm3 = 50;
      program.report.bounds = {{0, 0}, {index, 9}};
    }
    return programs;
  }
  absl::StatusOr<ExposureEnvelope> Envelope(const StageCall&, const ExposureSummary& summary,
                                            const ExposureSettings&) const override {
    return ExposureEnvelope{
        absl::StrCat(summary.object_names[0], " ", summary.layers.size(), " ", summary.bounds.max.x,
                     " ", ToMm(summary.layers.back().print_z_nm), " ", summary.time_s, " ",
                     summary.settings_text, ": "),
        heads, "end"};
  }

  int lost = -1;
  std::vector<std::string> heads;
  bool dark = false;
};

class LaserProcessTest : public testing::Test {
 protected:
  absl::StatusOr<JobOutput> Run(std::string layers, int slots = 2) {
    Dispatcher dispatcher;
    dispatcher.Join({.name = "here", .tasks = chain_, .slots = slots});
    JobInput input;
    input.settings = settings_;
    input.settings_text = "contours";
    input.warnings = {"of the settings"};
    input.meshes.files = {{"thing", MeshFormat::kStl, std::move(layers)}};
    std::vector<std::unique_ptr<JobProcess>> processes;
    processes.push_back(std::make_unique<LaserProcess>(slicing_, exposure_));
    return JobPipeline(std::move(processes), dispatcher).Run({}, std::move(input), nullptr);
  }

  JobSettings settings_ = {.slicing = {}, .own = ExposureSettings()};
  FakeSlicing slicing_;
  FakeExposure exposure_;
  std::shared_ptr<LaserChain> chain_ = std::make_shared<LaserChain>(exposure_);
};

TEST_F(LaserProcessTest, PutsTheFileTogether) {
  const auto output = Run("x-x");
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_EQ(*output->program.Whole(), "thing 3 2 3 1.5 contours: 0x2 1x2 2x2 end");
}

TEST_F(LaserProcessTest, LayersComeAfterTheirHeads) {
  exposure_.heads = {"a", "b", "c"};
  const auto output = Run("x-x");
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_EQ(*output->program.Whole(), "thing 3 2 3 1.5 contours: a0x2 b1x2 c2x2 end");
  exposure_.heads = {"a", "b"};
  EXPECT_EQ(DetailOf(Run("x-x").status()).reason, Reason::kInternal);
}

TEST_F(LaserProcessTest, RecoatingIsPartOfEachLayersTime) {
  ExposureOf(settings_).output.recoat_s = 10;
  const auto output = Run("x-x");
  ASSERT_TRUE(output.ok()) << output.status();
  const JobReport& report = output->report;
  const auto& own = dynamic_cast<const LaserReport&>(*report.own);
  EXPECT_EQ(own.layer_s, (std::vector<double>{10.75, 10, 10.75}));
  EXPECT_DOUBLE_EQ(own.recoating_s, 30);
  EXPECT_DOUBLE_EQ(report.print_time_s, 31.5);
  EXPECT_DOUBLE_EQ(own.exposure.TimeS(), 1.5);
  EXPECT_TRUE(output->program.Whole()->starts_with("thing 3 2 3 31.5 "));
}

TEST_F(LaserProcessTest, ReportsWhatItCameTo) {
  const auto output = Run("x-x");
  ASSERT_TRUE(output.ok()) << output.status();
  const JobReport& report = output->report;
  EXPECT_EQ(report.layer_count, 3);
  EXPECT_DOUBLE_EQ(report.object_height_mm, 3);
  EXPECT_DOUBLE_EQ(report.print_time_s, 1.5);
  const auto& own = dynamic_cast<const LaserReport&>(*report.own);
  EXPECT_EQ(own.exposure.Total().lines, 2);
  EXPECT_DOUBLE_EQ(own.exposure.EnergyDensityJmm3(), 2);
  EXPECT_THAT(report.warnings, testing::Contains("of the settings"));
}

TEST_F(LaserProcessTest, ReportsTimesByLayer) {
  const auto output = Run("x-x");
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_EQ(dynamic_cast<const LaserReport&>(*output->report.own).layer_s,
            (std::vector<double>{0.75, 0, 0.75}));
}

/// The exposed area extends from (0, 0) to (2, 9) nm.
TEST_F(LaserProcessTest, SkywritingStaysOnTheBed) {
  ExposureOptions& options = ExposureOf(settings_).regions[0];
  options.strategy = ScanStrategy::kHatch;
  options.skywriting_nm = 1'000'000;
  settings_.slicing.bed = {{-1'000'000, -1'000'000},
                           {5'000'000, -1'000'000},
                           {5'000'000, 5'000'000},
                           {-1'000'000, 5'000'000}};
  EXPECT_TRUE(Run("xxx").ok());
  options.skywriting_nm = 1'000'001;
  const ErrorDetail detail = DetailOf(Run("xxx").status());
  EXPECT_EQ(detail.reason, Reason::kOutOfBuildVolume);
  EXPECT_EQ(detail.metadata.at("setting"), "skywriting");
  options.strategy = ScanStrategy::kRings;
  EXPECT_TRUE(Run("xxx").ok()) << "rings have no such runs";
  options.contour_run_nm = 1'000'001;
  EXPECT_EQ(DetailOf(Run("xxx").status()).metadata.at("setting"), "contour_run");
}

TEST_F(LaserProcessTest, SameBytesForAnyNumberOfSlots) {
  ExposureOf(settings_).regions[0].upskin_layers = 3;
  const std::string layers = std::string(200, 'x') + "--" + std::string(50, 'x');
  const auto one = Run(layers, 1);
  ASSERT_TRUE(one.ok()) << one.status();
  for (const int slots : {2, 5, 32})
    EXPECT_EQ(*Run(layers, slots)->program.Whole(), *one->program.Whole()) << slots;
}

TEST_F(LaserProcessTest, NothingToScanIsAnError) {
  EXPECT_EQ(DetailOf(Run("---").status()).reason, Reason::kNothingToPrint);
  exposure_.dark = true;
  EXPECT_EQ(DetailOf(Run("xxx").status()).reason, Reason::kNothingToPrint);
}

TEST_F(LaserProcessTest, ALayerThatDoesNotComeBackIsAnError) {
  for (const int lost : {0, 1, 2}) {
    exposure_.lost = lost;
    EXPECT_EQ(DetailOf(Run("xxx").status()).reason, Reason::kInternal) << lost;
  }
}

TEST_F(LaserProcessTest, ADrawingOfALayerThatIsNotThereIsAnError) {
  ExposureOf(settings_).output.format = OutputFormat::kDxf;
  ExposureOf(settings_).output.layer = 2;
  EXPECT_TRUE(Run("xxx").ok());
  ExposureOf(settings_).output.layer = 3;
  const ErrorDetail detail = DetailOf(Run("xxx").status());
  EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(detail.metadata.at("setting"), "output_layer");
  EXPECT_EQ(detail.metadata.at("max"), "2");
}

}  // namespace
}  // namespace slicefarm::coordinator::laser_process_test
