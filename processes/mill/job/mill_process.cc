#include "processes/mill/job/mill_process.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/span_log.h"
#include "common/base/stopwatch.h"
#include "common/stage/job_memory.h"
#include "processes/mill/job/mill_estimate.h"
#include "processes/mill/job/mill_job_report.h"
#include "processes/mill/job/mill_scene.h"
#include "processes/mill/job/step_split.h"
#include "services/coordinator/algo/pipeline/mesh_warnings.h"

namespace slicefarm::coordinator {
namespace {

absl::StatusOr<MillScene> PlaceScene(const StageCall& call, const PlacingStage& placing,
                                     PlacingInput job, const MillSettings& settings) {
  auto split = TakeStock(std::move(job), settings.stock);
  if (!split.ok()) return split.status();
  auto parts = placing.Place(call, std::move(split->parts.meshes), split->parts.options);
  if (!parts.ok()) return parts.status();
  std::optional<PlacedScene> stock;
  if (split->stock) {
    PutAround(*parts, *split->stock);
    auto placed = placing.Place(call, std::move(split->stock->meshes), split->stock->options);
    if (!placed.ok()) return placed.status();
    stock = *std::move(placed);
  }
  return MillSceneOf(*std::move(parts), std::move(stock), settings);
}

/// Returns the memory of a mesh, in bytes. The job holds this memory until it ends.
int64_t BytesOf(const IndexedMesh& mesh) {
  return static_cast<int64_t>(mesh.vertices.size() * sizeof(mesh.vertices[0]) +
                              mesh.triangles.size() * sizeof(mesh.triangles[0]));
}

class MillJob : public PlannedJob {
 public:
  MillJob(const MillingStage& milling, Shared<MillInput> input, MillLayout layout,
          std::string settings_text, JobReport report, std::unique_ptr<SpoolFile> spool)
      : milling_(milling),
        input_(std::move(input)),
        layout_(std::move(layout)),
        settings_text_(std::move(settings_text)),
        report_(std::move(report)),
        spool_(std::move(spool)) {}

  int32_t Weight() const override {
    if (IsPicture()) return layout_.weights[Shown()];
    return std::accumulate(layout_.weights.begin(), layout_.weights.end(), int32_t{0});
  }

  absl::StatusOr<std::vector<Task>> Tasks(int slots) override {
    std::vector<Task> tasks;
    for (const MillTask& task : SplitSteps(layout_, input_, slots)) {
      const bool shows = task.steps.first <= input_->settings.output_step &&
                         input_->settings.output_step < task.steps.last;
      if (!IsPicture()) {
        tasks.emplace_back(task);
      } else if (shows) {
        const int32_t step = input_->settings.output_step;
        tasks.emplace_back(MillTask{{step, step + 1},
                                    task.phase,
                                    task.phase_first + step - task.steps.first,
                                    Weight(),
                                    input_});
      }
    }
    made_.resize(tasks.size());
    return tasks;
  }

  absl::Status Take(size_t task, TaskResult result) override {
    made_[task] = std::move(result.As<MillResult>());
    return absl::OkStatus();
  }

  absl::StatusOr<JobOutput> Assemble(const StageCall& call) override {
    std::vector<MilledStep> steps;
    for (MillResult& made : made_) {
      report_.stage_times.Add(made.times);
      std::ranges::move(made.steps, std::back_inserter(steps));
    }
    made_.clear();
    if (absl::Status whole = CheckSteps(steps); !whole.ok()) return whole;
    auto program = Timed(report_.stage_times[Stage::kMilling], [&] {
      const ScopedSpan span(call.spans, "assembly");
      return milling_.Assemble(call, input_, std::move(steps), settings_text_);
    });
    if (!program.ok()) return program.status();
    Report(program->report);
    SpooledText text(std::move(spool_));
    text.Add(std::move(program->text));
    return JobOutput{std::move(text), std::move(report_)};
  }

 private:
  bool IsPicture() const { return input_->settings.format == MillFormat::kSvg; }
  size_t Shown() const { return static_cast<size_t>(input_->settings.output_step); }

  absl::Status CheckSteps(const std::vector<MilledStep>& steps) const {
    const size_t first = IsPicture() ? Shown() : 0;
    const size_t count = IsPicture() ? 1 : layout_.steps.size();
    for (size_t i = 0; i < std::min(count, steps.size()); ++i)
      if (steps[i].step != layout_.steps[first + i])
        return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                         absl::StrCat("step ", first + i, " came back as another one"));
    if (steps.size() == count) return absl::OkStatus();
    return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                     absl::StrCat(steps.size(), " of ", count, " steps came back"));
  }

  void Report(const MillReport& milled) {
    report_.print_time_s = milled.Seconds();
    report_.layer_count = static_cast<int32_t>(std::ranges::count_if(
        layout_.steps, [](const MillStep& step) { return step.phase != MillPhase::kRest; }));
    report_.object_height_mm = layout_.part_mm.sizes().z();
    if (milled.gouges > 0)
      report_.warnings.push_back(absl::StrCat("the program cuts into the part at ", milled.gouges,
                                              " of ", milled.checked, " checked points"));
    auto own = std::make_unique<MillJobReport>();
    own->report = milled;
    own->cutter = input_->settings.how.cutter.name();
    own->layout = std::move(layout_);
    report_.own = std::move(own);
  }

  const MillingStage& milling_;
  const Shared<MillInput> input_;
  MillLayout layout_;
  const std::string settings_text_;
  JobReport report_;
  std::unique_ptr<SpoolFile> spool_;
  std::vector<MillResult> made_;  ///< one per task
};

}  // namespace

absl::StatusOr<std::unique_ptr<PlannedJob>> MillProcess::Plan(const StageCall& call,
                                                              JobInput input) const {
  JobReport report;
  const MillSettings& settings = MillOf(input.settings);
  auto scene = Timed(report.stage_times[Stage::kPlacing], [&] {
    const ScopedSpan span(call.spans, "placing");
    return PlaceScene(call, placing_, {std::move(input.meshes), input.settings.slicing}, settings);
  });
  if (!scene.ok()) return scene.status();
  const absl::Status held = HoldMemory(call, JobMemory::Kind::kMeshes,
                                       BytesOf(scene->input.part) + BytesOf(scene->input.stock));
  if (!held.ok()) return held;
  const Shared<MillInput> shared(std::move(scene->input));
  auto layout = Timed(report.stage_times[Stage::kMilling], [&] {
    const ScopedSpan span(call.spans, "layout");
    return milling_.LayOut(call, shared);
  });
  if (!layout.ok()) return layout.status();
  if (layout->steps.empty())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                     "there is no level to mill: check stepdown, `bottom` and the stock");
  report.meshes = std::move(scene->meshes);
  report.warnings = std::move(input.warnings);
  std::ranges::move(scene->warnings, std::back_inserter(report.warnings));
  for (const MeshReport& mesh : report.meshes)
    std::ranges::move(MeshWarnings(mesh), std::back_inserter(report.warnings));
  auto spool = SpoolFile::Make(spool_directory_);
  if (!spool.ok()) return spool.status();
  return std::make_unique<MillJob>(milling_, shared, *std::move(layout),
                                   std::move(input.settings_text), std::move(report),
                                   *std::move(spool));
}

absl::StatusOr<JobEstimate> MillProcess::Estimate(const StageCall& /*call*/, SlicedJob sliced,
                                                  JobInput input,
                                                  TaskExecutor& /*executor*/) const {
  return EstimateMilling({sliced.layers, sliced.copies}, MillOf(input.settings).how);
}

std::unique_ptr<JobProcess> MillProcess::Over(const Stages& stages,
                                              const std::string& spool_directory) {
  if (stages.placing == nullptr || stages.milling == nullptr) return nullptr;
  return std::make_unique<MillProcess>(*stages.placing, *stages.milling, spool_directory);
}

}  // namespace slicefarm::coordinator
