#include "services/coordinator/algo/pipeline/job_pipeline.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/base/error.h"
#include "common/base/span_log.h"
#include "common/base/stopwatch.h"
#include "services/coordinator/algo/pipeline/layer_plan.h"
#include "services/coordinator/algo/pipeline/mesh_warnings.h"
#include "services/coordinator/algo/pipeline/range_split.h"

namespace slicefarm::coordinator {
namespace {

/// `layers` and `plans` whole; the tasks point into them.
std::vector<RangeTask> MakeTasks(std::span<const SlicedLayer> layers,
                                 std::span<const LayerPlan> plans, const JobSettings& settings,
                                 int slots) {
  const int32_t count = static_cast<int32_t>(layers.size());
  const int32_t halo = HaloLayers(settings);
  std::vector<RangeTask> tasks;
  for (const LayerRange& range : SplitIntoRanges(layers, slots)) {
    const LayerRange grown = range.Grown(halo, count);
    tasks.push_back({.range = range,
                     .layer_count = count,
                     .layers = layers.subspan(grown.first, grown.size()),
                     .plans = plans.subspan(range.first, range.size()),
                     .settings = &settings});
  }
  return tasks;
}

absl::Status CheckPrograms(const std::vector<RangeResult>& results, size_t layer_count) {
  size_t index = 0;
  for (const RangeResult& result : results) {
    for (const LayerProgram& program : result.programs) {
      if (program.frame.index != static_cast<int32_t>(index)) {
        return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                         absl::StrCat("layer ", index, " came back as ", program.frame.index));
      }
      ++index;
    }
  }
  if (index == layer_count) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                   absl::StrCat(index, " of ", layer_count, " layers came back"));
}

/// A part that ends between two planes may leave outlines at its top that no bead fits into.
/// Printing ends with the last layer that has beads; empty layers below it stay. Errors:
/// InvalidArgument (NOTHING_TO_PRINT) if there is none.
absl::Status DropEmptyTop(std::vector<RangeResult>& results) {
  for (auto result = results.rbegin(); result != results.rend(); ++result) {
    std::vector<LayerProgram>& programs = result->programs;
    while (!programs.empty() && programs.back().stats.ExtrudedMm() == 0) programs.pop_back();
    if (!programs.empty()) return absl::OkStatus();
  }
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                   "the outlines of all layers are too thin for a bead");
}

LayerSummary Summarize(const LayerProgram& program) {
  return {.frame = program.frame,
          .entry = program.entry,
          .exit = program.exit,
          .time_s = program.stats.TimeS(),
          .empty = program.stats.ExtrudedMm() == 0};
}

ProgramSummary Summarize(const std::vector<RangeResult>& results, StageTimes& times) {
  ProgramSummary summary;
  for (const RangeResult& result : results) {
    times.Add(result.times);
    for (const LayerProgram& program : result.programs) {
      summary.layers.push_back(Summarize(program));
      summary.total.Add(program.stats);
    }
  }
  return summary;
}

/// Prologue, prefixes and programs, epilogue. Each part is freed as soon as it is copied.
std::string Assemble(ProgramFrame frame, std::vector<RangeResult> results) {
  size_t size = frame.prologue.size() + frame.epilogue.size();
  for (const std::string& prefix : frame.layer_prefixes) size += prefix.size();
  for (const RangeResult& result : results) {
    for (const LayerProgram& program : result.programs) size += program.gcode.size();
  }
  std::string gcode;
  gcode.reserve(size);
  gcode += frame.prologue;
  size_t layer = 0;
  for (RangeResult& result : results) {
    for (LayerProgram& program : result.programs) {
      if (layer < frame.layer_prefixes.size()) gcode += frame.layer_prefixes[layer];
      gcode += program.gcode;
      std::string().swap(program.gcode);
      ++layer;
    }
  }
  gcode += frame.epilogue;
  return gcode;
}

/// Nothing if all islands got the walls that were asked for.
std::string WallWarning(const ProgramSummary& summary) {
  int64_t islands = 0;
  std::vector<int32_t> layers;
  for (const LayerSummary& layer : summary.layers) {
    if (layer.frame.plain_islands > 0) layers.push_back(layer.frame.index);
    islands += layer.frame.plain_islands;
  }
  if (islands == 0) return {};
  constexpr size_t kNamed = 5;
  const size_t named = std::min(kNamed, layers.size());
  return absl::StrCat(
      islands,
      " islands got walls of constant width and gap fill, as no trustworthy medial axis "
      "of their outlines was found; in layers ",
      absl::StrJoin(layers.begin(), layers.begin() + static_cast<std::ptrdiff_t>(named), ", "),
      layers.size() > named ? absl::StrCat(" and ", layers.size() - named, " more") : "");
}

void FillIn(JobReport& report, const ProgramSummary& summary, const ProgramFrame& frame,
            const MotionOptions& motion) {
  report.stats = summary.total;
  report.layer_count = static_cast<int32_t>(summary.layers.size());
  for (const LayerSummary& layer : summary.layers) {
    if (!layer.empty) report.object_height_mm = ToMm(layer.frame.print_z_nm);
  }
  report.print_time_s = frame.time_s;
  report.travel_mm = frame.travel_mm;
  report.filament = FilamentUseOf(summary.total, motion);
  for (const MeshReport& mesh : report.meshes) {
    for (std::string& warning : MeshWarnings(mesh)) report.warnings.push_back(std::move(warning));
  }
  if (std::string warning = WallWarning(summary); !warning.empty())
    report.warnings.push_back(std::move(warning));
}

/// Plan, ranges, executor: outlines to programs. The outlines are freed at the end.
absl::StatusOr<std::vector<RangeResult>> RunRanges(
    const StageCall& call, std::vector<SlicedLayer> layers, const JobSettings& settings,
    RangeExecutor& executor, const std::function<void(PipelineProgress)>& progress) {
  std::optional<ScopedSpan> planning(std::in_place, call.spans, "plan");
  const auto plans = PlanLayers(layers, settings.ordering.seam, call.cancel);
  if (!plans.ok()) return plans.status();
  planning.reset();
  const int32_t total = static_cast<int32_t>(layers.size());
  const auto tell = [&](int32_t done) {
    if (progress) progress({.layers_total = total, .layers_done = done});
  };
  tell(0);
  const auto tasks = MakeTasks(layers, *plans, settings, executor.Slots());
  ScopedSpan span(call.spans, "ranges");
  span.Set("layers", absl::StrCat(total));
  span.Set("ranges", absl::StrCat(tasks.size()));
  auto results = executor.Execute(call, tasks, tell);
  if (!results.ok()) return results.status();
  if (absl::Status whole = CheckPrograms(*results, layers.size()); !whole.ok()) return whole;
  return results;
}

}  // namespace

absl::Status CheckPrintable(std::span<const SlicedLayer> layers) {
  const bool printable = std::any_of(layers.begin(), layers.end(),
                                     [](const SlicedLayer& l) { return !l.objects.empty(); });
  if (printable) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                   "no layer of the meshes has an outline to print");
}

absl::StatusOr<JobOutput> JobPipeline::Run(
    const StageCall& call, JobInput input,
    const std::function<void(PipelineProgress)>& progress) const {
  JobOutput output;
  JobReport& report = output.report;
  JobSettings& settings = input.settings;

  auto sliced = Timed(report.stage_times.slicing_s, [&] {
    const ScopedSpan span(call.spans, "slicing");
    return slicing_.Slice(call, std::move(input.meshes), settings.slicing);
  });
  if (!sliced.ok()) return sliced.status();
  if (absl::Status printable = CheckPrintable(sliced->layers); !printable.ok()) return printable;
  report.meshes = std::move(sliced->meshes);
  report.warnings = std::move(input.warnings);
  settings.motion.layer_count = static_cast<int32_t>(sliced->layers.size());

  auto results = RunRanges(call, std::move(sliced->layers), settings, executor_, progress);
  if (!results.ok()) return results.status();
  if (absl::Status printable = DropEmptyTop(*results); !printable.ok()) return printable;

  ProgramSummary summary = Summarize(*results, report.stage_times);
  summary.thumbnails = std::move(sliced->thumbnails);
  summary.object_names = std::move(sliced->object_names);
  summary.settings_text = std::move(input.settings_text);
  auto frame = Timed(report.stage_times.motion_s, [&] {
    const ScopedSpan span(call.spans, "frame");
    return motion_.Frame(call, summary, settings.motion);
  });
  if (!frame.ok()) return frame.status();

  const ScopedSpan span(call.spans, "assembly");
  FillIn(report, summary, *frame, settings.motion);
  output.gcode = Assemble(*std::move(frame), *std::move(results));
  return output;
}

}  // namespace slicefarm::coordinator
