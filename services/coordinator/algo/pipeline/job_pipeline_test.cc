#include "services/coordinator/algo/pipeline/job_pipeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "absl/strings/str_cat.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"
#include "common/base/error.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"

namespace slicefarm::coordinator {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Squares, as many layers as the file has bytes; '0' bytes are empty layers, '-' bytes outlines
/// that no bead fits into.
class FakeSlicing : public SlicingStage {
 public:
  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions&) const override {
    if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
    SlicedJob job;
    for (const char c : input.files[0].bytes) {
      SlicedLayer layer;
      layer.frame = {static_cast<int32_t>(job.layers.size()), FromMm(0.2 * (job.layers.size() + 1)),
                     FromMm(0.2)};
      if (c == '-') layer.objects = {{0, MakePolygonsOrDie("(1 1, 9 1, 9 1.01)")}};
      if (c == 'x') layer.objects = {{0, MakePolygonsOrDie("(1 1, 9 1, 9 9, 1 9)")}};
      job.layers.push_back(layer);
    }
    job.object_names = {"thing"};
    job.meshes.resize(1);
    job.meshes[0].name = "thing";
    job.meshes[0].open_edges = 1;
    job.thumbnails = {{1, 1, "png"}};
    return job;
  }
};

/// Writes what it was given: its layer, plan and neighbours.
class FakeRanges : public RangeRunner {
 public:
  absl::StatusOr<RangeResult> Run(const StageCall& call, const RangeTask& task) const override {
    EXPECT_EQ(call.threads, 1);
    EXPECT_EQ(task.layers.front().frame.index, std::max(0, task.range.first - 5));
    EXPECT_EQ(task.layers.back().frame.index, std::min(task.layer_count, task.range.last + 5) - 1);
    RangeResult result;
    result.times.infill_s = 1;
    for (int i = task.range.first; i < task.range.last; ++i) {
      LayerProgram program;
      program.frame = task.layers[i - task.layers.front().frame.index].frame;
      const LayerPlan& plan = task.plans[i - task.range.first];
      const auto& objects = task.layers[i - task.layers.front().frame.index].objects;
      if (!objects.empty() && Area(objects[0].outlines) > 1e12) {
        program.gcode = absl::StrCat("layer ", i, " at ", ToText(plan.entry), "\n");
        program.stats.features[0] = {2, 3, 4, 5};
        if (i == 1) program.frame.plain_islands = 3;
      }
      result.programs.push_back(program);
    }
    return result;
  }
};

class FakeMotion : public MotionStage {
 public:
  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall&, std::vector<OrderedLayer>,
                                                    const MotionOptions&) const override {
    return absl::UnimplementedError("");
  }
  absl::StatusOr<ProgramFrame> Frame(const StageCall&, const ProgramSummary& summary,
                                     const MotionOptions&) const override {
    ProgramFrame frame;
    frame.prologue =
        absl::StrCat("begin ", summary.object_names.at(0), " ", summary.thumbnails.size(), "\n");
    for (const LayerSummary& layer : summary.layers) {
      frame.layer_prefixes.push_back(absl::StrCat(layer.empty ? "empty " : "", layer.time_s, ": "));
    }
    frame.epilogue = "end " + summary.settings_text;
    frame.time_s = summary.total.TimeS() + 100;
    frame.travel_mm = 50;
    return frame;
  }
};

JobInput InputOf(std::string bytes) {
  JobInput input;
  input.warnings = {"of the settings"};
  input.meshes.files = {{"thing", MeshFormat::kUnknown, std::move(bytes)}};
  input.meshes.placements.resize(1);
  input.settings.ordering.seam = SeamPosition::kNearest;
  input.settings_text = "layer_height = 0.2";
  return input;
}

class JobPipelineTest : public testing::Test {
 protected:
  absl::StatusOr<JobOutput> Run(std::string bytes, int slots = 2, const StageCall& call = {}) {
    Dispatcher dispatcher;
    dispatcher.Join({.name = "here", .ranges = std::make_shared<FakeRanges>(), .slots = slots});
    return JobPipeline(slicing_, motion_, dispatcher)
        .Run(call, InputOf(std::move(bytes)),
             [this](PipelineProgress p) { progress_.push_back(p); });
  }

  FakeSlicing slicing_;
  FakeMotion motion_;
  std::vector<PipelineProgress> progress_;
};

TEST_F(JobPipelineTest, PrintingEndsWithTheLastLayerThatHasBeads) {
  const std::string expected = Run("x-x")->gcode;
  EXPECT_THAT(expected, HasSubstr("empty"));
  for (const char* bytes : {"x-x-", "x-x0", "x-x-0-", "x-x---------------"}) {
    for (const int slots : {1, 2, 4}) {
      const auto output = Run(bytes, slots);
      ASSERT_TRUE(output.ok()) << output.status();
      EXPECT_EQ(output->gcode, expected) << bytes;
      EXPECT_EQ(output->report.layer_count, 3) << bytes;
    }
  }
}

TEST_F(JobPipelineTest, OutlinesThatNoBeadFitsIntoAreAnError) {
  const auto output = Run("---");
  EXPECT_EQ(output.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(DetailOf(output.status()).reason, Reason::kNothingToPrint);
}

TEST_F(JobPipelineTest, PutsTheProgramTogether) {
  const auto output = Run("x0x");
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_EQ(output->gcode,
            "begin thing 1\n"
            "2: layer 0 at 0 0\n"
            "empty 0: "
            "2: layer 2 at 1 1\n"
            "end layer_height = 0.2");
}

TEST_F(JobPipelineTest, ReportsWhatItCameTo) {
  const auto output = Run("xxx0");
  ASSERT_TRUE(output.ok()) << output.status();
  const JobReport& report = output->report;
  EXPECT_EQ(report.layer_count, 3);
  EXPECT_DOUBLE_EQ(report.object_height_mm, 0.6);
  EXPECT_DOUBLE_EQ(report.print_time_s, 106);
  EXPECT_DOUBLE_EQ(report.travel_mm, 50);
  EXPECT_DOUBLE_EQ(report.filament.length_mm, 12);
  EXPECT_DOUBLE_EQ(report.filament.volume_mm3, 15);
  EXPECT_DOUBLE_EQ(report.filament.mass_g, 15 * 1.24e-3);
  EXPECT_DOUBLE_EQ(report.stage_times.infill_s, 1);
  EXPECT_THAT(report.warnings, ElementsAre("of the settings", HasSubstr("1 edge"),
                                           HasSubstr("3 islands got walls of constant width")));
}

TEST_F(JobPipelineTest, TellsItsProgress) {
  ASSERT_TRUE(Run(std::string(100, 'x')).ok());
  ASSERT_GE(progress_.size(), 2u);
  EXPECT_EQ(progress_.front().layers_done, 0);
  EXPECT_EQ(progress_.back().layers_done, 100);
  for (size_t i = 1; i < progress_.size(); ++i) {
    EXPECT_EQ(progress_[i].layers_total, 100);
    EXPECT_LE(progress_[i - 1].layers_done, progress_[i].layers_done);
  }
}

TEST_F(JobPipelineTest, SameBytesForAnyNumberOfSlots) {
  const std::string layers = std::string(300, 'x') + "00" + std::string(100, 'x');
  const auto one = Run(layers, 1);
  ASSERT_TRUE(one.ok());
  for (const int slots : {2, 3, 8, 64}) EXPECT_EQ(Run(layers, slots)->gcode, one->gcode) << slots;
}

TEST_F(JobPipelineTest, NothingToPrintIsAnError) {
  for (const char* bytes : {"", "000"}) {
    const auto output = Run(bytes);
    EXPECT_EQ(DetailOf(output.status()).reason, Reason::kNothingToPrint) << output.status();
  }
}

TEST_F(JobPipelineTest, IsCancelled) {
  StageCall call;
  call.cancel = CancelToken([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(Run("xxx", 2, call).status()));
}

}  // namespace
}  // namespace slicefarm::coordinator
