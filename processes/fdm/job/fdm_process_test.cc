#include "processes/fdm/job/fdm_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "common/stage/motion_job.h"
#include "common/stage/slice_input_test.h"
#include "processes/fdm/job/fdm_report.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/fdm_task.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"

namespace slicefarm::coordinator::fdm_process_test {
namespace {

const FdmReport& OwnOf(const JobOutput& output) {
  return dynamic_cast<const FdmReport&>(*output.report.own);
}

using testing::ElementsAre;
using testing::HasSubstr;

/// Distance from each copy to the next one on its right.
constexpr Coord kStepNm = 20'000'000;

/// Slicing stage that returns squares, one layer per byte of the file. A '0' byte is an empty
/// layer. A '-' byte is an outline that is too small for a bead.
class FakeSlicing : public SlicingStage {
 public:
  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions&) const override {
    if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
    SlicedJob job;
    const std::string& bytes = input.files.at(0).bytes;
    for (const char c : bytes) {
      SlicedLayer layer;
      layer.frame = {static_cast<int32_t>(job.layers.size()), FromMm(0.2 * (job.layers.size() + 1)),
                     FromMm(0.2)};
      ObjectSection section;
      section.layer = layer.frame.index;
      section.layer_count = static_cast<int32_t>(bytes.size());
      section.height_nm = layer.frame.height_nm;
      if (c == '-') section.regions = {{.outlines = MakePolygonsOrDie("(1 1, 9 1, 9 1.01)")}};
      if (c == 'x') section.regions = {{.outlines = MakePolygonsOrDie("(1 1, 9 1, 9 9, 1 9)")}};
      layer.sections = {section};
      job.layers.push_back(layer);
    }
    job.object_names = {input.objects.at(0).name};
    for (size_t i = 0; i < input.objects[0].copies.size(); ++i)
      job.copies.push_back({0, {static_cast<Coord>(i) * kStepNm, 0}, {}});
    job.meshes.resize(1);
    job.meshes[0].name = "thing";
    job.meshes[0].open_edges = 1;
    job.thumbnails = {{1, 1, "png"}};
    return job;
  }
};

/// Planning stage. Layer i begins at (i, 0).
class FakePlanning : public PlanningStage {
 public:
  absl::StatusOr<JobPlan> Plan(const StageCall&, const SlicedOutlines& job,
                               const PlanningOptions&) const override {
    if (!fails.ok()) return fails;
    JobPlan plan;
    for (const SlicedLayer& layer : job.layers)
      plan.layers.push_back(
          {.entry = {FromMm(layer.frame.index), 0}, .sections = {}, .paths = {}, .infill = {}});
    plan.stacks = stacks;
    plan.skirt = skirt;
    for (int32_t i = 0; i < more_layers; ++i) plan.layers.emplace_back();
    int32_t index = 0;
    for (const PlacedCopy& copy : job.copies)
      plan.copies.push_back({copy.object, copy.shift, one_by_one ? index++ : 0});
    return plan;
  }

  absl::Status fails;
  std::vector<AddedStack> stacks;
  Skirt skirt;
  int32_t more_layers = 0;  ///< number of layers beyond the layers of the parts
  bool one_by_one = false;  ///< each copy is a pass
};

/// Runner that writes its input: the layer, the plan and the neighbours.
class FakeRanges : public FdmRunner {
 public:
  absl::StatusOr<FdmResult> Run(const StageCall& call, const FdmTask& task) const override {
    EXPECT_EQ(call.threads, 1);
    EXPECT_EQ(task.layers.front().frame.index, std::max(0, task.range.first - 6));
    // The facts of several passes contain the total number of layers.
    const auto layers =
        task.job->facts.layer_count / std::max<int32_t>(1, std::ssize(task.job->facts.passes));
    EXPECT_EQ(task.layers.back().frame.index, std::min(layers, task.range.last + 6) - 1);
    EXPECT_EQ(task.job->facts.copies.size(), task.job->copies.size());
    std::set<int32_t> passes;
    for (const Copy& copy : task.job->copies) passes.insert(copy.pass);
    FdmResult result;
    result.times[Stage::kInfill] = 1;
    for (int i = task.range.first; i < task.range.last; ++i) {
      if (i == lost) continue;
      const SlicedLayer& layer = task.layers[i - task.layers.front().frame.index];
      const bool has_beads = HasBeads(layer.sections.back());
      if (i == 1 && has_beads) result.warnings.push_back({i, 3});
      if (has_beads)
        result.fills.push_back({.settings = i % 2, .pattern = {}, .area_mm2 = 0.1 * i, .paths = 1});
      for (const int32_t pass : passes) {
        if (pass > 0 && !has_beads) continue;
        LayerProgram program;
        program.frame = layer.frame;
        program.pass = pass;
        if (has_beads) {
          program.gcode = TextOf(layer, task.plans[i - task.range.first], pass);
          program.stats.features[0] = {2, 3, 4, 5};
        }
        result.programs.push_back(program);
      }
    }
    return result;
  }

  int lost = -1;  ///< a layer that the runner does not return

 private:
  static bool HasBeads(const ObjectSection& section) { return Area(OutlineOf(section)) > 1e12; }

  static std::string TextOf(const SlicedLayer& layer, const LayerPlan& plan, int32_t pass) {
    std::string text = absl::StrCat("layer ", layer.frame.index, " at ", ToText(plan.entry));
    for (const ObjectSection& section : layer.sections)
      if (section.stack.object == kPlateObject)
        absl::StrAppend(&text, ", plate ", ToMm(section.height_nm));
    if (!plan.paths.empty()) absl::StrAppend(&text, ", paths ", plan.paths.size());
    if (pass > 0) absl::StrAppend(&text, ", pass ", pass);
    return text + "\n";
  }
};

class FakeMotion : public MotionStage {
 public:
  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall&, std::vector<OrderedLayer>,
                                                    const Shared<MotionJob>&) const override {
    return absl::UnimplementedError("");
  }
  absl::StatusOr<ProgramEnvelope> Envelope(const StageCall&, const ProgramSummary& summary,
                                           const MotionOptions& options) const override {
    ProgramEnvelope frame;
    if (!options.writing.substitutions.empty()) frame.head = "; layer head\n";
    if (!options.writing.substitutions.empty()) frame.tail = "\n; layer tail\n";
    frame.file_name = "thing.gcode";
    frame.prologue = "begin";
    for (const CopySummary& copy : summary.copies) {
      const CopyName& name = copy.name;
      absl::StrAppend(&frame.prologue, " ", name.object_name, " ", name.copy, "/", name.copies);
    }
    absl::StrAppend(&frame.prologue, " ", summary.thumbnails.size(), "\n");
    for (const LayerSummary& layer : summary.layers) {
      frame.layer_prefixes.push_back(absl::StrCat(layer.empty ? "empty " : "", layer.time_s, ": "));
    }
    frame.epilogue = "end " + summary.settings_text;
    frame.times.travel_s = summary.total.TimeS() + 100;
    frame.travel_mm = 50;
    return frame;
  }
};

class FdmProcessTest : public testing::Test {
 protected:
  JobInput JobOf(std::string bytes) const {
    JobInput input;
    input.warnings = {"of the settings"};
    input.meshes = slicefarm::InputOf({{"thing", MeshFormat::kUnknown, std::move(bytes)}});
    input.meshes.objects[0].copies.resize(copies_);
    input.settings_text = "layer_height = 0.2";
    FdmOf(input.settings).machine.motion.writing = writing_;
    return input;
  }

  absl::StatusOr<JobOutput> Run(std::string bytes, int slots = 2, const StageCall& call = {}) {
    Dispatcher dispatcher;
    dispatcher.Join({.name = "here", .tasks = ranges_, .slots = slots});
    std::vector<std::unique_ptr<JobProcess>> processes;
    processes.push_back(std::make_unique<FdmProcess>(slicing_, planning_, motion_));
    return JobPipeline(std::move(processes), dispatcher)
        .Run(call, JobOf(std::move(bytes)), [this](PipelineProgress p) { progress_.push_back(p); });
  }

  FakeSlicing slicing_;
  FakePlanning planning_;
  FakeMotion motion_;
  std::shared_ptr<FakeRanges> ranges_ = std::make_shared<FakeRanges>();
  size_t copies_ = 1;
  WritingOptions writing_;
  std::vector<PipelineProgress> progress_;
};

TEST_F(FdmProcessTest, PrintingEndsWithTheLastLayerThatHasBeads) {
  const std::string expected = *Run("x-x")->program.Whole();
  EXPECT_THAT(expected, HasSubstr("empty"));
  for (const char* bytes : {"x-x-", "x-x0", "x-x-0-", "x-x---------------"}) {
    for (const int slots : {1, 2, 4}) {
      const auto output = Run(bytes, slots);
      ASSERT_TRUE(output.ok()) << output.status();
      EXPECT_EQ(*output->program.Whole(), expected) << bytes;
      EXPECT_EQ(output->report.layer_count, 3) << bytes;
    }
  }
}

TEST_F(FdmProcessTest, OutlinesThatNoBeadFitsIntoAreAnError) {
  const auto output = Run("---");
  EXPECT_EQ(output.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(DetailOf(output.status()).reason, Reason::kNothingToPrint);
}

TEST_F(FdmProcessTest, PutsTheProgramTogether) {
  const auto output = Run("x0x");
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_EQ(*output->program.Whole(),
            "begin thing 0/1 1\n"
            "2: layer 0 at 0 0\n"
            "empty 0: "
            "2: layer 2 at 2 0\n"
            "end layer_height = 0.2");
}

TEST_F(FdmProcessTest, SubstitutesInAllButHeadAndTail) {
  writing_.substitutions = R"("^2: layer (\\d) .*\\n";"L$1\\n";r;;begin;BEGIN;;;"end layer";END;;)";
  const auto output = Run("x0x");
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_EQ(*output->program.Whole(),
            "; layer head\nBEGIN thing 0/1 1\nL0\nempty 0: L2\n"
            "END_height = 0.2\n; layer tail\n");
  EXPECT_EQ(output->report.file_name, "thing.gcode");
}

TEST_F(FdmProcessTest, RefusesSubstitutionsThatCannotBeMade) {
  writing_.substitutions = "(;;r;";
  const auto output = Run("xxx");
  EXPECT_EQ(DetailOf(output.status()).reason, Reason::kSettingMalformed);
  EXPECT_EQ(DetailOf(output.status()).metadata.at("setting"), "gcode_substitutions");
}

TEST_F(FdmProcessTest, MakesABinaryFile) {
  writing_.binary = true;
  EXPECT_THAT(*Run("xxx")->program.Whole(), testing::StartsWith("GCDE"));
}

TEST_F(FdmProcessTest, PassesFollowEachOtherAndEndWhereTheirBeadsDo) {
  copies_ = 2;
  planning_.one_by_one = true;
  const auto output = Run("x0x-");
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_EQ(*output->program.Whole(),
            "begin thing 0/2 thing 1/2 1\n"
            "2: layer 0 at 0 0\n"
            "empty 0: "
            "2: layer 2 at 2 0\n"
            "2: layer 0 at 0 0, pass 1\n"
            "2: layer 2 at 2 0, pass 1\n"
            "end layer_height = 0.2");
  EXPECT_DOUBLE_EQ(output->report.object_height_mm, 0.6);
}

/// Returns a stack of the plate with one layer, of which the top is at `top_nm`.
AddedStack OnPlate(int32_t id, Coord top_nm, Coord height_nm) {
  AddedStack added;
  added.stack = Stack(id, kPlateObject, StackKind::kRaft);
  ObjectSection& section = added.sections.emplace_back();
  section.stack = added.stack;
  section.z_nm = top_nm;
  section.height_nm = height_nm;
  section.regions = {{.role = Role::kRaft, .outlines = MakePolygonsOrDie("(0 0, 9 0, 0 9)")}};
  return added;
}

TEST_F(FdmProcessTest, WhatPlanningAddsReachesItsLayers) {
  planning_.stacks = {OnPlate(1, FromMm(0.2), FromMm(0.3)), OnPlate(2, FromMm(0.2), FromMm(0.1))};
  planning_.skirt = {std::vector<Path>(2), 1};
  const auto output = Run("xxx");
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_THAT(*output->program.Whole(),
              HasSubstr("layer 0 at 0 0, plate 0.3, plate 0.1, paths 2\n"));
  EXPECT_THAT(*output->program.Whole(), HasSubstr("layer 1 at 1 0\n"));
}

TEST_F(FdmProcessTest, LayersOfThePrintThatPlanningDidNotPlanAreAnError) {
  planning_.stacks = {OnPlate(1, FromMm(0.3), FromMm(0.1))};
  EXPECT_EQ(DetailOf(Run("xxx").status()).reason, Reason::kInternal) << "0.3 is between two";
  planning_.stacks.clear();
  planning_.skirt = {{}, 4};
  EXPECT_EQ(DetailOf(Run("xxx").status()).reason, Reason::kInternal) << "of a skirt on three";
}

TEST_F(FdmProcessTest, ErrorsOfPlanningEndTheJob) {
  planning_.fails = absl::UnavailableError("no plan");
  EXPECT_EQ(Run("xxx").status(), planning_.fails);
  EXPECT_TRUE(progress_.empty());
}

TEST_F(FdmProcessTest, ALayerThatDoesNotComeBackIsAnError) {
  for (const int lost : {0, 1, 2}) {
    ranges_->lost = lost;
    EXPECT_EQ(DetailOf(Run("xxx").status()).reason, Reason::kInternal) << lost;
  }
}

TEST_F(FdmProcessTest, ReportsWhatItCameTo) {
  const auto output = Run("xxx0");
  ASSERT_TRUE(output.ok()) << output.status();
  const JobReport& report = output->report;
  EXPECT_EQ(report.layer_count, 3);
  EXPECT_DOUBLE_EQ(report.object_height_mm, 0.6);
  EXPECT_DOUBLE_EQ(report.print_time_s, 106);
  EXPECT_DOUBLE_EQ(OwnOf(*output).travel_mm, 50);
  EXPECT_DOUBLE_EQ(report.filament.length_mm, 12);
  EXPECT_DOUBLE_EQ(report.filament.volume_mm3, 15);
  EXPECT_DOUBLE_EQ(report.filament.mass_g, 15 * 1.24e-3);
  EXPECT_DOUBLE_EQ(report.stage_times[Stage::kInfill], 1);
  EXPECT_THAT(report.warnings,
              ElementsAre("of the settings", HasSubstr("1 edge"),
                          AllOf(HasSubstr("3 islands were printed with walls of constant width"),
                                testing::EndsWith("layers 1"))));
}

TEST_F(FdmProcessTest, SumsUpWhatInfillComesTo) {
  const auto output = Run("xxxxx0");
  ASSERT_TRUE(output.ok()) << output.status();
  const std::vector<FillStats>& fills = OwnOf(*output).fills;
  ASSERT_EQ(fills.size(), 2u);
  EXPECT_EQ(fills[0].paths, 3);
  EXPECT_DOUBLE_EQ(fills[0].area_mm2, 0.6);
  EXPECT_EQ(fills[1].settings, 1);
  EXPECT_EQ(fills[1].paths, 2);
}

TEST_F(FdmProcessTest, TellsItsProgress) {
  ASSERT_TRUE(Run(std::string(100, 'x')).ok());
  ASSERT_GE(progress_.size(), 2u);
  EXPECT_EQ(progress_.front().done, 0);
  EXPECT_EQ(progress_.back().done, 100);
  for (size_t i = 1; i < progress_.size(); ++i) {
    EXPECT_EQ(progress_[i].total, 100);
    EXPECT_LE(progress_[i - 1].done, progress_[i].done);
  }
}

TEST_F(FdmProcessTest, SameBytesForAnyNumberOfSlots) {
  const std::string layers = std::string(300, 'x') + "00" + std::string(100, 'x');
  copies_ = 2;
  for (const bool one_by_one : {false, true}) {
    planning_.one_by_one = one_by_one;
    const auto one = Run(layers, 1);
    ASSERT_TRUE(one.ok());
    for (const int slots : {2, 3, 8, 64}) {
      const auto many = Run(layers, slots);
      EXPECT_EQ(*many->program.Whole(), *one->program.Whole()) << slots;
      EXPECT_EQ(OwnOf(*many).fills, OwnOf(*one).fills) << slots;
    }
  }
}

TEST_F(FdmProcessTest, NothingToPrintIsAnError) {
  for (const char* bytes : {"", "000"}) {
    const auto output = Run(bytes);
    EXPECT_EQ(DetailOf(output.status()).reason, Reason::kNothingToPrint) << output.status();
  }
}

TEST_F(FdmProcessTest, IsCancelled) {
  StageCall call;
  call.cancel = CancelToken([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(Run("xxx", 2, call).status()));
}

}  // namespace
}  // namespace slicefarm::coordinator::fdm_process_test
