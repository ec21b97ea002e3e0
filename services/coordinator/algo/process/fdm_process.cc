#include "services/coordinator/algo/process/fdm_process.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <span>
#include <string_view>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "common/base/error.h"
#include "common/base/span_log.h"
#include "common/base/stopwatch.h"
#include "common/gcode/binary/binary_gcode.h"
#include "common/gcode/substitutions.h"
#include "common/geometry/boolean/boolean.h"
#include "common/model/bead_section.h"
#include "common/model/fields/field_notes.h"
#include "common/model/fields/field_text.h"
#include "common/stage/object_layers.h"
#include "services/coordinator/algo/pipeline/bed_warnings.h"
#include "services/coordinator/algo/pipeline/check_printable.h"
#include "services/coordinator/algo/pipeline/mesh_warnings.h"
#include "services/coordinator/algo/pipeline/pass_facts.h"
#include "services/coordinator/algo/pipeline/range_split.h"

namespace slicefarm::coordinator {
namespace {

/// The regions of a plate lie apart, each in its own place.
MultiPolygon WholeOf(const std::vector<Region>& regions) {
  MultiPolygon all;
  for (const Region& region : regions)
    all.insert(all.end(), region.outlines.begin(), region.outlines.end());
  return Union(all, {});
}

/// What cannot be as exact as the regions' density fields ask for.
std::vector<std::string> FieldNotesOf(const JobSettings& settings) {
  std::vector<std::string> notes;
  if (settings.slicing.objects.empty()) return notes;
  const Coord height = settings.slicing.objects.front().layer_height_nm;
  for (const InfillOptions& options : settings.infill) {
    if (options.density_field.empty() || options.choose_pattern) continue;
    const auto field = ParseDensityField(options.density_field);
    if (!field.ok()) continue;  // the infill stage says so
    const Coord spacing = Spacing(options.sparse_width_nm, height);
    std::ranges::move(FieldNotes(*field, options.pattern, ToMm(static_cast<double>(spacing))),
                      std::back_inserter(notes));
  }
  return notes;
}

/// Puts what planning adds to the plate where the stages look for it: regions among the sections of
/// their layer, finished paths into its plan.
absl::Status AddToPlate(std::vector<SlicedLayer>& layers, JobPlan& plan) {
  for (PlateAddition& addition : plan.additions) {
    if (addition.layer < 0 || addition.layer >= std::ssize(layers))
      return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                       absl::StrCat("planning added to layer ", addition.layer, " of ",
                                    layers.size()));
    const auto layer = static_cast<size_t>(addition.layer);
    std::ranges::move(addition.paths, std::back_inserter(plan.layers[layer].paths));
    if (addition.regions.empty()) continue;
    ObjectSection plate;
    plate.object = kPlate;
    plate.height_nm = addition.height_nm;
    plate.regions = std::move(addition.regions);
    if (plate.regions.size() > 1) plate.whole = WholeOf(plate.regions);
    std::vector<ObjectSection>& sections = layers[layer].sections;
    const auto first = std::ranges::find_if(
        sections, [](const ObjectSection& section) { return section.object != kPlate; });
    sections.insert(first, std::move(plate));
  }
  return absl::OkStatus();
}

/// Nobody but planning asks where seams should be.
void DropSeamParts(std::vector<SlicedLayer>& layers) {
  for (SlicedLayer& layer : layers) {
    for (ObjectSection& section : layer.sections) {
      section.seam_enforcers.clear();
      section.seam_blockers.clear();
    }
  }
}

/// The names of the copies, in their order.
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

absl::Status CheckPrograms(const std::vector<FdmResult>& results, size_t layer_count) {
  int32_t next = 0;
  int32_t pass = -1;
  for (const FdmResult& result : results) {
    for (const LayerProgram& program : result.programs) {
      const int32_t index = program.frame.index;
      const bool next_pass = index == next - 1 && program.pass > pass;
      if (index != next && !next_pass)
        return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                         absl::StrCat("layer ", next, " came back as ", index));
      next = index + 1;
      pass = program.pass;
    }
  }
  if (next == static_cast<int32_t>(layer_count)) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                   absl::StrCat(next, " of ", layer_count, " layers came back"));
}

/// All programs in the order of printing: by pass, then bottom up.
std::vector<LayerProgram> InOrder(std::vector<FdmResult> results) {
  std::vector<LayerProgram> programs;
  for (FdmResult& result : results)
    std::ranges::move(result.programs, std::back_inserter(programs));
  std::ranges::stable_sort(programs, {}, &LayerProgram::pass);
  return programs;
}

/// An object that ends between two planes may leave outlines at its top that no bead fits into. A
/// pass ends with the last layer that has beads; empty layers below it stay. Errors:
/// InvalidArgument (NOTHING_TO_PRINT) if there is none at all.
absl::Status DropEmptyTops(std::vector<LayerProgram>& programs) {
  std::vector<LayerProgram> kept;
  std::map<int32_t, size_t> last;  // of a pass, with beads
  const auto is_empty = [](const LayerProgram& program) {
    return program.stats.ExtrudedMm() == 0;
  };
  for (size_t i = 0; i < programs.size(); ++i)
    if (!is_empty(programs[i])) last[programs[i].pass] = i;
  for (size_t i = 0; i < programs.size(); ++i) {
    const auto end = last.find(programs[i].pass);
    if (end != last.end() && i <= end->second) kept.push_back(std::move(programs[i]));
  }
  programs = std::move(kept);
  if (!programs.empty()) return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
      "no layer has a bead: the outlines are too thin for one, or the settings ask for "
      "none (perimeters, fill_density, solid layers)");
}

LayerSummary Summarize(const LayerProgram& program) {
  return {.frame = program.frame,
          .pass = program.pass,
          .entry = program.entry,
          .exit = program.exit,
          .time_s = program.stats.TimeS(),
          .empty = program.stats.ExtrudedMm() == 0,
          .edges = program.edges,
          .filament_mm = program.stats.FilamentMm()};
}

ProgramSummary Summarize(const std::vector<LayerProgram>& programs) {
  ProgramSummary summary;
  for (const LayerProgram& program : programs) {
    summary.layers.push_back(Summarize(program));
    summary.total.Add(program.stats);
  }
  return summary;
}

/// A layer's G-code with what its places were kept free for.
void AddLayer(const LayerProgram& program, std::span<const std::string> code, std::string& gcode) {
  const std::string_view text = program.gcode;
  size_t done = 0;
  for (size_t i = 0; i < std::min(code.size(), program.code_at.size()); ++i) {
    const auto at = static_cast<size_t>(program.code_at[i]);
    gcode.append(text.substr(done, at - done)).append(code[i]);
    done = at;
  }
  gcode.append(text.substr(done));
}

/// Head, prologue, prefixes and programs, epilogue, tail. Each part is freed as soon as it is
/// copied. `substitutions` are made in all but head and tail, layer by layer.
std::string WholeProgram(ProgramEnvelope frame, std::vector<LayerProgram> programs,
                         const gcode::Substitutions& substitutions) {
  size_t size =
      frame.head.size() + frame.prologue.size() + frame.epilogue.size() + frame.tail.size();
  for (const std::string& prefix : frame.layer_prefixes) size += prefix.size();
  for (const std::string& code : frame.layer_code) size += code.size();
  for (const LayerProgram& program : programs) size += program.gcode.size();
  std::string gcode;
  gcode.reserve(size);
  gcode += frame.head;
  gcode += substitutions.Apply(std::move(frame.prologue));
  for (size_t i = 0; i < programs.size(); ++i) {
    const size_t begin = gcode.size();
    if (i < frame.layer_prefixes.size()) gcode += frame.layer_prefixes[i];
    const size_t first = std::min(i * kCodesOfALayer, frame.layer_code.size());
    const size_t count = std::min<size_t>(kCodesOfALayer, frame.layer_code.size() - first);
    AddLayer(programs[i], std::span(frame.layer_code).subspan(first, count), gcode);
    std::string().swap(programs[i].gcode);
    if (substitutions.empty()) continue;
    const std::string layer = substitutions.Apply(gcode.substr(begin));
    gcode.replace(begin, std::string::npos, layer);
  }
  gcode += substitutions.Apply(std::move(frame.epilogue));
  gcode += frame.tail;
  return gcode;
}

/// The file that the settings ask for.
absl::StatusOr<std::string> MakeFile(ProgramEnvelope frame, std::vector<LayerProgram> programs,
                                     const WritingOptions& writing) {
  const auto substitutions = gcode::Substitutions::Of(gcode::TextsOfList(writing.substitutions));
  if (!substitutions.ok())
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
        absl::StrCat("gcode_substitutions: ", std::string(substitutions.status().message())),
        {{"setting", "gcode_substitutions"}});
  std::string text = WholeProgram(std::move(frame), std::move(programs), *substitutions);
  if (!writing.binary) return text;
  auto file = gcode::BinaryGcode(text);
  if (file.ok()) return file;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   absl::StrCat("binary_gcode = 1: ", std::string(file.status().message())),
                   {{"setting", "binary_gcode"}, {"value", "1"}});
}

/// Nothing if all islands got the walls that were asked for.
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
      " islands got walls of constant width and gap fill, as no trustworthy medial axis "
      "of their outlines was found; in layers ",
      absl::StrJoin(layers.begin(), layers.begin() + static_cast<std::ptrdiff_t>(named), ", "),
      layers.size() > named ? absl::StrCat(" and ", layers.size() - named, " more") : "");
}

void FillIn(JobReport& report, const ProgramSummary& summary, const ProgramEnvelope& frame,
            const MotionOptions& motion) {
  report.stats = summary.total;
  for (size_t i = 0; i < frame.times.feature_s.size(); ++i)
    report.stats.features[i].time_s = frame.times.feature_s[i];
  report.stats.retract_time_s = frame.times.retract_s;
  report.stats.travel_time_s = frame.times.travel_s + frame.times.retract_s;
  report.layer_count = static_cast<int32_t>(summary.layers.size());
  for (const LayerSummary& layer : summary.layers) {
    const double top_mm = ToMm(static_cast<double>(layer.frame.print_z_nm));
    if (!layer.empty) report.object_height_mm = std::max(report.object_height_mm, top_mm);
  }
  report.print_time_s = frame.times.TotalS();
  report.file_name = frame.file_name;
  report.times = frame.times;
  report.travel_mm = frame.travel_mm;
  report.filament = FilamentUseOf(summary.total, motion);
  for (const MeshReport& mesh : report.meshes) {
    for (std::string& warning : MeshWarnings(mesh)) report.warnings.push_back(std::move(warning));
  }
}

/// Copies with their names, for those who read G-code.
std::vector<CopySummary> SummarizeCopies(std::vector<CopyName> names,
                                         std::vector<PlacedCopy> copies) {
  std::vector<CopySummary> summaries;
  for (size_t i = 0; i < names.size(); ++i)
    summaries.push_back({std::move(names[i]), std::move(copies[i].footprint)});
  return summaries;
}

class FdmJob : public PlannedJob {
 public:
  FdmJob(const MotionStage& motion, JobSettings settings, std::string settings_text,
         JobReport report)
      : motion_(motion),
        settings_(std::move(settings)),
        settings_text_(std::move(settings_text)),
        report_(std::move(report)) {}

  absl::Status Take(SlicedJob sliced, JobPlan plan) {
    layers_ = std::move(sliced.layers);
    DropSeamParts(layers_);
    plan_ = std::move(plan);
    copies_ = std::move(sliced.copies);
    thumbnails_ = std::move(sliced.thumbnails);
    if (absl::Status added = AddToPlate(layers_, plan_); !added.ok()) return added;
    PassPlan passes = PassesOf(layers_, plan_.copies);
    facts_ = {passes.layer_count, NamesOf(sliced.object_names, copies_), std::move(passes.passes)};
    return absl::OkStatus();
  }

  int32_t LayerCount() const override { return static_cast<int32_t>(layers_.size()); }

  std::vector<Task> Tasks(int slots) const override {
    const std::span<const SlicedLayer> layers = layers_;
    const std::span<const LayerPlan> plans = plan_.layers;
    const int32_t halo = HaloLayers(settings_);
    std::vector<Task> tasks;
    for (const LayerRange& range : SplitIntoRanges(layers, slots)) {
      const LayerRange grown = WithHalo(layers, range, halo);
      const auto at = [](int32_t index) { return static_cast<size_t>(index); };
      tasks.push_back(FdmTask{.range = range,
                              .layers = layers.subspan(at(grown.first), at(grown.size())),
                              .plans = plans.subspan(at(range.first), at(range.size())),
                              .copies = plan_.copies,
                              .facts = &facts_,
                              .settings = &settings_});
    }
    return tasks;
  }

  absl::StatusOr<JobOutput> Assemble(const StageCall& call,
                                     std::vector<TaskResult> results) override {
    const auto layer_count = layers_.size();
    layers_ = {};
    std::vector<FdmResult> ranges;
    std::vector<LayerWarning> warnings;
    for (TaskResult& result : results) {
      ranges.push_back(std::get<FdmResult>(std::move(result)));
      report_.stage_times.Add(ranges.back().times);
      std::ranges::copy(ranges.back().warnings, std::back_inserter(warnings));
      for (const FillUse& use : ranges.back().fills) AddUse(use, 1, report_.fills);
    }
    if (absl::Status whole = CheckPrograms(ranges, layer_count); !whole.ok()) return whole;
    std::vector<LayerProgram> programs = InOrder(std::move(ranges));
    if (absl::Status printable = DropEmptyTops(programs); !printable.ok()) return printable;

    ProgramSummary summary = Summarize(programs);
    summary.thumbnails = std::move(thumbnails_);
    summary.copies = SummarizeCopies(std::move(facts_.copies), std::move(copies_));
    summary.settings_text = std::move(settings_text_);
    auto frame = Timed(report_.stage_times.motion_s, [&] {
      const ScopedSpan span(call.spans, "frame");
      return motion_.Envelope(call, summary, settings_.motion);
    });
    if (!frame.ok()) return frame.status();

    const ScopedSpan span(call.spans, "assembly");
    FillIn(report_, summary, *frame, settings_.motion);
    if (std::string warning = WallWarning(warnings); !warning.empty())
      report_.warnings.push_back(std::move(warning));
    auto file = MakeFile(*std::move(frame), std::move(programs), settings_.motion.writing);
    if (!file.ok()) return file.status();
    return JobOutput{*std::move(file), std::move(report_)};
  }

 private:
  const MotionStage& motion_;
  const JobSettings settings_;
  std::string settings_text_;
  JobReport report_;
  std::vector<SlicedLayer> layers_;
  JobPlan plan_;
  JobFacts facts_;
  std::vector<PlacedCopy> copies_;
  std::vector<Thumbnail> thumbnails_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<PlannedJob>> FdmProcess::Plan(const StageCall& call,
                                                             JobInput input) const {
  JobReport report;
  const JobSettings& settings = input.settings;
  auto sliced = Timed(report.stage_times.slicing_s, [&] {
    const ScopedSpan span(call.spans, "slicing");
    return slicing_.Slice(call, std::move(input.meshes), settings.slicing);
  });
  if (!sliced.ok()) return sliced.status();
  if (absl::Status printable = CheckPrintable(sliced->layers); !printable.ok()) return printable;
  report.meshes = std::move(sliced->meshes);
  report.warnings = std::move(input.warnings);

  auto plan = Timed(report.stage_times.planning_s, [&] {
    const ScopedSpan span(call.spans, "planning");
    PlanningOptions options = settings.planning;
    options.infill = InfillPlansOf(settings);
    return planning_.Plan(call, {sliced->layers, sliced->copies, sliced->object_names}, options);
  });
  if (!plan.ok()) return plan.status();
  report.seams = plan->seams;
  std::ranges::move(BedWarnings(plan->additions, settings.planning.bed, sliced->copies,
                                sliced->object_names),
                    std::back_inserter(report.warnings));
  report.notes = std::move(plan->notes);
  std::ranges::move(FieldNotesOf(settings), std::back_inserter(report.notes));
  auto job = std::make_unique<FdmJob>(motion_, std::move(input.settings),
                                      std::move(input.settings_text), std::move(report));
  if (absl::Status taken = job->Take(*std::move(sliced), *std::move(plan)); !taken.ok())
    return taken;
  return job;
}

}  // namespace slicefarm::coordinator
