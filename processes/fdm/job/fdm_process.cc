#include "processes/fdm/job/fdm_process.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/base/error.h"
#include "common/base/span_log.h"
#include "common/base/stopwatch.h"
#include "common/gcode/archive/gcode_archive.h"
#include "common/gcode/binary/binary_gcode.h"
#include "common/gcode/substitutions.h"
#include "common/geometry/rings/simplify.h"
#include "common/model/bead_section.h"
#include "common/model/fields/field_notes.h"
#include "common/model/fields/field_text.h"
#include "common/stage/job_memory.h"
#include "common/stage/object_layers.h"
#include "common/stage/print_layers.h"
#include "processes/fdm/job/bed_warnings.h"
#include "processes/fdm/job/fdm_programs.h"
#include "processes/fdm/job/fdm_report.h"
#include "processes/fdm/job/pass_facts.h"
#include "processes/fdm/job/plate_archive.h"
#include "processes/fdm/job/print_estimate.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/fdm_task.h"
#include "services/coordinator/algo/pipeline/check_printable.h"
#include "services/coordinator/algo/pipeline/mesh_warnings.h"
#include "services/coordinator/algo/pipeline/range_split.h"

namespace slicefarm::coordinator {
namespace {

/// Returns notes about density fields that the regions' infill cannot follow exactly.
std::vector<std::string> FieldNotesOf(const JobSettings& settings) {
  std::vector<std::string> notes;
  if (settings.slicing.objects.empty()) return notes;
  const Coord height = settings.slicing.objects.front().layer_height_nm;
  for (const RegionRow& region : FdmOf(settings).regions) {
    const InfillOptions& options = region.infill;
    if (options.density_field.empty() || options.choose_pattern) continue;
    const auto& field = DensityFieldOf(options.density_field);
    if (!field.ok()) continue;  // the infill stage reports the error
    const Coord spacing = Spacing(options.sparse_width_nm, height);
    std::ranges::move(FieldNotes(*field, options.pattern, ToMm(static_cast<double>(spacing))),
                      std::back_inserter(notes));
  }
  return notes;
}

/// Removes the marks of all sections, because only planning uses them.
void DropMarks(std::vector<SlicedLayer>& layers) {
  for (SlicedLayer& layer : layers)
    for (ObjectSection& section : layer.sections) section.marks.clear();
}

/// Returns the layers of the print, with everything that planning adds. The added stacks and the
/// skirt are moved out of `plan`.
absl::StatusOr<std::vector<SlicedLayer>> TakeLayers(std::vector<SlicedLayer> parts, JobPlan& plan) {
  DropMarks(parts);
  std::vector<SlicedLayer> layers = PrintLayers(std::move(parts), std::exchange(plan.lifts_nm, {}),
                                                std::exchange(plan.stacks, {}));
  const Skirt skirt = std::exchange(plan.skirt, {});
  if (layers.size() != plan.layers.size() || skirt.layers > std::ssize(layers))
    return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                     absl::StrCat("planning planned ", plan.layers.size(),
                                  " layers and a skirt on ", skirt.layers, " of ", layers.size()));
  int32_t left = skirt.layers;
  Coord below_nm = 0;
  for (size_t i = 0; i < layers.size() && left > 0; ++i) {
    if (OnlySupports(layers[i])) continue;
    const bool upper = left < skirt.layers && !skirt.upper_loops.empty();
    plan.layers[i].paths = upper ? skirt.upper_loops : skirt.loops;
    const LayerFrame& frame = layers[i].frame;
    if (frame.print_z_nm - below_nm != frame.height_nm)
      plan.layers[i].paths_height_nm = frame.print_z_nm - below_nm;
    below_nm = frame.print_z_nm;
    --left;
  }
  return layers;
}

/// Returns the names of the copies, in their order.
std::vector<CopyName> NamesOf(const std::vector<std::string>& objects,
                              const std::vector<PlacedCopy>& copies) {
  std::vector<int32_t> count(objects.size(), 0);
  std::vector<CopyName> names;
  for (const PlacedCopy& copy : copies) {
    const auto object = static_cast<size_t>(copy.object);
    names.push_back({objects[object], copy.object, count[object]++, 1});
  }
  for (CopyName& name : names) name.copies = count[static_cast<size_t>(name.object)];
  return names;
}

/// Returns true if the number of layers of a print depends on planning, not only on the outlines.
bool NeedsPlan(const FdmSettings& settings) {
  return settings.machine.plan.sequence.complete_objects ||
         std::ranges::any_of(settings.objects, [](const ObjectRow& object) {
           return object.raft.heights.layers > 0 || object.support.on;
         });
}

/// Approximate number of bytes of G-code per point of an outline.
constexpr int64_t kBytesAPoint = 40;

/// Returns the options for cutting the layers into ranges. G-code that each layer repeats counts as
/// additional points, so that ranges have programs of similar length.
RangeSplitOptions SplitOptionsOf(const FdmSettings& settings) {
  const MachineMotion& motion = settings.machine.motion;
  RangeSplitOptions options;
  const size_t bytes = motion.before_layer_gcode.size() + motion.layer_gcode.size();
  options.layer_points += static_cast<int64_t>(bytes) / kBytesAPoint;
  return options;
}

/// Returns the file in the format that the settings request. `plate`: facts for an archive.
absl::StatusOr<SpooledText> MakeFile(ProgramEnvelope frame,
                                     const std::vector<SpooledProgram>& programs,
                                     const WritingOptions& writing, gcode::ArchivedPlate plate,
                                     std::unique_ptr<SpoolFile> spool, const StageCall& call) {
  const auto substitutions = gcode::Substitutions::Of(gcode::TextsOfList(writing.substitutions));
  if (!substitutions.ok())
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
        absl::StrCat("gcode_substitutions: ", std::string(substitutions.status().message())),
        {{"setting", "gcode_substitutions"}});
  auto text =
      WholeProgram(std::move(frame), programs, *substitutions, std::move(spool), call.cancel);
  if (!text.ok() || (!writing.binary && !writing.archive)) return text;
  // Binary G-code has its metadata before the text, and its blocks are compressed as a whole; an
  // archive has the checksum of the text. Therefore the text and the file are in memory at the same
  // time.
  if (absl::Status held = HoldMemory(call, JobMemory::Kind::kProgram, 2 * text->size()); !held.ok())
    return held;
  auto whole = text->Whole();
  if (!whole.ok()) return whole.status();
  if (writing.archive) {
    plate.gcode = *std::move(whole);
    auto archive = gcode::GcodeArchive({std::move(plate)});
    if (!archive.ok())
      return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                       std::string(archive.status().message()));
    return SpooledText(*std::move(archive));
  }
  auto file = gcode::BinaryGcode(*whole);
  if (file.ok()) return SpooledText(*std::move(file));
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   absl::StrCat("binary_gcode = 1: ", std::string(file.status().message())),
                   {{"setting", "binary_gcode"}, {"value", "1"}});
}

/// Returns a warning about islands that did not get the requested walls; empty if all islands got
/// them.
std::string WallWarning(const std::vector<LayerWarning>& warnings) {
  int64_t islands = 0;
  std::vector<int32_t> layers;
  for (const LayerWarning& warning : warnings) {
    if (warning.plain_islands > 0) layers.push_back(warning.layer);
    islands += warning.plain_islands;
  }
  if (islands == 0) return {};
  constexpr size_t kNamed = 5;
  const size_t named = std::min(kNamed, layers.size());
  return absl::StrCat(
      islands,
      " islands were printed with walls of constant width and gap fill, because walls of variable "
      "width failed for their outlines; layers ",
      absl::StrJoin(layers.begin(), layers.begin() + static_cast<std::ptrdiff_t>(named), ", "),
      layers.size() > named ? absl::StrCat(" and ", layers.size() - named, " more") : "");
}

/// Returns the division of the print into the shares of its copies.
PrintShares SharesOf(const ProgramSummary& summary, const PrintTimes& times,
                     const PrintShare& total, const MotionOptions& motion) {
  std::vector<CopyName> names;
  std::vector<PrintShare> shares;
  for (size_t i = 0; i < summary.copies.size(); ++i) {
    const CopySummary& copy = summary.copies[i];
    names.push_back(copy.name);
    const double time_s = i < times.copy_s.size() ? times.copy_s[i] : copy.use.time_s;
    shares.push_back({time_s, FilamentUseOf(copy.use, motion)});
  }
  return DividePrint(names, std::move(shares), total);
}

void FillIn(JobReport& report, FdmReport& own, const ProgramSummary& summary,
            const ProgramEnvelope& frame, const MotionOptions& motion) {
  own.stats = summary.total;
  for (size_t i = 0; i < frame.times.feature_s.size(); ++i)
    own.stats.features[i].time_s = frame.times.feature_s[i];
  own.stats.retract_time_s = frame.times.retract_s;
  own.stats.travel_time_s = frame.times.travel_s + frame.times.retract_s;
  own.times = frame.times;
  own.travel_mm = frame.travel_mm;
  report.layer_count = static_cast<int32_t>(summary.layers.size());
  for (const LayerSummary& layer : summary.layers) {
    const double top_mm = ToMm(static_cast<double>(layer.frame.print_z_nm));
    if (!layer.empty) report.object_height_mm = std::max(report.object_height_mm, top_mm);
  }
  report.print_time_s = frame.times.TotalS();
  report.file_name = frame.file_name;
  report.filament = FilamentUseOf(summary.total, motion);
  report.shares = SharesOf(summary, frame.times, {report.print_time_s, report.filament}, motion);
  own.file_name = report.file_name;
  own.filament = report.filament;
  for (const MeshReport& mesh : report.meshes) {
    for (std::string& warning : MeshWarnings(mesh)) report.warnings.push_back(std::move(warning));
  }
}

/// Tolerance of the outlines of copies in the G-code.
constexpr Coord kOutlineToleranceNm = 50'000;

/// Returns the copies with their names and simplified outlines, for comments in the G-code.
std::vector<CopySummary> SummarizeCopies(std::vector<CopyName> names,
                                         std::vector<PlacedCopy> copies) {
  std::vector<CopySummary> summaries;
  for (size_t i = 0; i < names.size(); ++i)
    summaries.push_back(
        {std::move(names[i]), SimplifyRing(copies[i].footprint, kOutlineToleranceNm), {}});
  return summaries;
}

class FdmJob : public PlannedJob {
 public:
  FdmJob(const MotionStage& motion, std::string settings_text, JobReport report, SeamQuality seams,
         std::unique_ptr<SpoolFile> spool)
      : motion_(motion),
        settings_text_(std::move(settings_text)),
        report_(std::move(report)),
        spool_(std::move(spool)) {
    own_.seams = seams;
  }

  absl::Status Begin(FdmSettings settings, SlicedJob sliced, JobPlan plan) {
    plan_ = std::move(plan);
    auto layers = TakeLayers(std::move(sliced.layers), plan_);
    if (!layers.ok()) return layers.status();
    layers_ = *std::move(layers);
    copies_ = std::move(sliced.copies);
    thumbnails_ = std::move(sliced.thumbnails);
    PassPlan passes = PassesOf(layers_, plan_.copies);
    job_ = FdmShared{
        std::move(settings),
        plan_.copies,
        {passes.layer_count, NamesOf(sliced.object_names, copies_), std::move(passes.passes)}};
    return absl::OkStatus();
  }

  int32_t Weight() const override { return static_cast<int32_t>(layers_.size()); }

  absl::StatusOr<std::vector<Task>> Tasks(int slots) override {
    const auto ranges = SplitIntoRanges(layers_, slots, SplitOptionsOf(job_->settings));
    absl::Status fits = CheckNeighbourhoods(layers_, ranges, HaloLayers(job_->settings));
    if (!fits.ok()) return fits;
    std::vector<Task> tasks = TasksFor(ranges);
    ranges_.resize(tasks.size());
    return tasks;
  }

  std::vector<Task> TasksFor(const std::vector<LayerRange>& ranges) const {
    const std::span<const SlicedLayer> layers = layers_;
    const std::span<const LayerPlan> plans = plan_.layers;
    const int32_t halo = HaloLayers(job_->settings);
    std::vector<Task> tasks;
    for (const LayerRange& range : ranges) {
      const LayerRange grown = WithHalo(layers, range, halo);
      const auto at = [](int32_t index) { return static_cast<size_t>(index); };
      tasks.push_back(FdmTask{.range = range,
                              .layers = layers.subspan(at(grown.first), at(grown.size())),
                              .plans = plans.subspan(at(range.first), at(range.size())),
                              .job = job_});
    }
    return tasks;
  }

  absl::Status Take(size_t task, TaskResult result) override {
    auto& made = result.As<FdmResult>();
    Range& range = ranges_[task];
    auto spooled = Spooled(std::move(made.programs), *spool_);
    if (!spooled.ok()) return spooled.status();
    range.programs = *std::move(spooled);
    range.rest = std::move(made);
    return absl::OkStatus();
  }

  absl::StatusOr<JobOutput> Assemble(const StageCall& call) override {
    const auto layer_count = layers_.size();
    layers_ = {};
    HoldMemory(call, JobMemory::Kind::kOutlines, 0).IgnoreError();
    plan_ = {};
    HoldMemory(call, JobMemory::Kind::kPlan, 0).IgnoreError();
    std::vector<SpooledProgram> all;
    std::vector<LayerWarning> warnings;
    for (Range& range : ranges_) {
      std::ranges::move(range.programs, std::back_inserter(all));
      report_.stage_times.Add(range.rest.times);
      std::ranges::copy(range.rest.warnings, std::back_inserter(warnings));
      for (const FillStats& use : range.rest.fills) AddUse(use, 1, own_.fills);
    }
    const auto programs = InPrintOrder(std::move(all), layer_count);
    if (!programs.ok()) return programs.status();

    const MotionOptions motion = MotionOf(job_->settings);
    auto summarized = SummaryOf(*programs);
    if (!summarized.ok()) return summarized.status();
    ProgramSummary& summary = *summarized;
    std::vector<Thumbnail> pictures = TakePlatePictures(thumbnails_);
    summary.thumbnails = std::move(thumbnails_);
    auto frame = Timed(report_.stage_times[Stage::kMotion], [&] {
      const ScopedSpan span(call.spans, "frame");
      return motion_.Envelope(call, summary, motion);
    });
    if (!frame.ok()) return frame.status();

    const ScopedSpan span(call.spans, "assembly");
    FillIn(report_, own_, summary, *frame, motion);
    report_.own = std::make_unique<FdmReport>(std::move(own_));
    if (std::string warning = WallWarning(warnings); !warning.empty())
      report_.warnings.push_back(std::move(warning));
    gcode::ArchivedPlate plate =
        ArchivedPlateOf(summary, frame->times, report_, job_->settings, std::move(pictures));
    auto file = MakeFile(*std::move(frame), *programs, motion.writing, std::move(plate),
                         std::move(spool_), call);
    if (!file.ok()) return file.status();
    return JobOutput{*std::move(file), std::move(report_)};
  }

  /// Returns the data of these programs that the envelope needs, except thumbnails.
  absl::StatusOr<ProgramSummary> SummaryOf(const std::vector<SpooledProgram>& programs) const {
    ProgramSummary summary = Summarize(programs);
    summary.copies = SummarizeCopies(job_->facts.copies, copies_);
    if (absl::Status added = AddCopyUses(programs, summary.copies); !added.ok()) return added;
    summary.settings_text = settings_text_;
    return summary;
  }

 private:
  /// Result of one task.
  struct Range {
    std::vector<SpooledProgram> programs;
    FdmResult rest;  ///< the result without its programs
  };

  const MotionStage& motion_;
  Shared<FdmShared> job_;
  std::string settings_text_;
  JobReport report_;
  FdmReport own_;
  std::unique_ptr<SpoolFile> spool_;
  std::vector<Range> ranges_;  ///< one per task
  std::vector<SlicedLayer> layers_;
  JobPlan plan_;
  std::vector<PlacedCopy> copies_;
  std::vector<Thumbnail> thumbnails_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<PlannedJob>> FdmProcess::Plan(const StageCall& call,
                                                             JobInput input) const {
  JobReport report;
  const JobSettings& settings = input.settings;
  auto sliced = Timed(report.stage_times[Stage::kSlicing], [&] {
    const ScopedSpan span(call.spans, "slicing");
    return slicing_.Slice(call, std::move(input.meshes), settings.slicing);
  });
  if (!sliced.ok()) return sliced.status();
  HoldMemory(call, JobMemory::Kind::kMeshes, 0).IgnoreError();
  if (absl::Status printable = CheckPrintable(sliced->layers); !printable.ok()) return printable;
  report.meshes = std::move(sliced->meshes);
  report.warnings = std::move(input.warnings);

  auto plan = Timed(report.stage_times[Stage::kPlanning], [&] {
    const ScopedSpan span(call.spans, "planning");
    return planning_.Plan(call, {sliced->layers, sliced->copies, sliced->object_names},
                          PlanningOf(FdmOf(settings)));
  });
  if (!plan.ok()) return plan.status();
  const SeamQuality seams = plan->seams;
  std::ranges::move(
      BedWarnings(*plan, FdmOf(settings).machine.plan.bed, sliced->copies, sliced->object_names),
      std::back_inserter(report.warnings));
  std::ranges::move(plan->warnings, std::back_inserter(report.warnings));
  report.notes = std::move(plan->notes);
  std::ranges::move(FieldNotesOf(settings), std::back_inserter(report.notes));
  auto spool = SpoolFile::Make(spool_directory_);
  if (!spool.ok()) return spool.status();
  auto job = std::make_unique<FdmJob>(motion_, std::move(input.settings_text), std::move(report),
                                      seams, *std::move(spool));
  absl::Status begun =
      job->Begin(std::move(FdmOf(input.settings)), *std::move(sliced), *std::move(plan));
  if (!begun.ok()) return begun;
  return job;
}

absl::StatusOr<LayerSamples> FdmProcess::Sample(const StageCall& call, PlannedPlate plate,
                                                std::span<const int32_t> layers,
                                                TaskExecutor& executor) const {
  const MotionOptions motion = MotionOf(plate.settings);
  FdmJob job(motion_, std::move(plate.settings_text), {}, {}, nullptr);
  absl::Status begun =
      job.Begin(std::move(plate.settings), std::move(plate.sliced), std::move(plate.plan));
  if (!begun.ok()) return begun;
  std::vector<LayerRange> ranges;
  for (const int32_t layer : layers) ranges.push_back({layer, layer + 1});
  std::vector<FdmResult> made(ranges.size());
  const auto take = [&](size_t task, TaskResult result) {
    made[task] = std::move(result.As<FdmResult>());
    return absl::OkStatus();
  };
  absl::Status done = executor.Execute(call, job.TasksFor(ranges), take, [](int32_t) {});
  if (!done.ok()) return done;
  LayerSamples samples;
  std::vector<SpooledProgram> programs;
  for (size_t i = 0; i < made.size(); ++i) {
    LayerSample& sample = samples.layers.emplace_back(LayerSample{layers[i]});
    for (LayerProgram& program : made[i].programs) {
      sample.time_s += program.stats.TimeS();
      sample.filament_mm += program.stats.FilamentMm();
      programs.push_back({std::move(program), {}});
    }
    samples.around_s -= sample.time_s;
  }
  std::ranges::stable_sort(programs, {},
                           [](const SpooledProgram& spooled) { return spooled.program.pass; });
  const auto summary = job.SummaryOf(programs);
  if (!summary.ok()) return summary.status();
  const auto frame = motion_.Envelope(call, *summary, motion);
  if (!frame.ok()) return frame.status();
  samples.around_s += frame->times.TotalS();
  return samples;
}

absl::StatusOr<JobEstimate> FdmProcess::Estimate(const StageCall& call, SlicedJob sliced,
                                                 JobInput input, TaskExecutor& executor) const {
  FdmSettings& settings = FdmOf(input.settings);
  const bool samples = executor.Slots(Process::kFdm) > 0;
  if (!samples && !NeedsPlan(settings))
    return EstimatePrint({sliced.layers, sliced.copies}, settings);
  const PlanningOptions options = PlanningOf(settings);
  auto plan = planning_.Plan(call, {sliced.layers, sliced.copies, sliced.object_names}, options);
  if (!plan.ok()) return plan.status();
  auto warnings = BedWarnings(*plan, options.bed, sliced.copies, sliced.object_names);
  auto print = TakeLayers(std::move(sliced.layers), *plan);
  if (!print.ok()) return print.status();
  sliced.layers = *std::move(print);
  const int32_t layers = PassesOf(sliced.layers, plan->copies).layer_count;
  if (!samples) {
    JobEstimate estimate = EstimatePrint({sliced.layers, sliced.copies}, settings);
    estimate.layers = layers;
    return estimate;
  }
  const std::vector<LayerEstimate> rough = EstimateLayers({sliced.layers, sliced.copies}, settings);
  const std::vector<int32_t> chosen = LayersToSample(rough, sliced.layers);
  const MotionOptions motion = MotionOf(settings);
  const auto made = Sample(
      call,
      {std::move(sliced), *std::move(plan), std::move(settings), std::move(input.settings_text)},
      chosen, executor);
  if (!made.ok()) return made.status();
  JobEstimate estimate = EstimateFrom(*made, rough, motion);
  estimate.layers = layers;
  estimate.warnings = std::move(warnings);
  return estimate;
}

std::unique_ptr<JobProcess> FdmProcess::Over(const Stages& stages,
                                             const std::string& spool_directory) {
  if (stages.slicing == nullptr || stages.planning == nullptr || stages.motion == nullptr)
    return nullptr;
  return std::make_unique<FdmProcess>(*stages.slicing, *stages.planning, *stages.motion,
                                      spool_directory);
}

}  // namespace slicefarm::coordinator
