#include "processes/laser/job/laser_process.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/span_log.h"
#include "common/base/stopwatch.h"
#include "common/stage/exposure_job.h"
#include "common/stage/job_memory.h"
#include "common/stage/object_layers.h"
#include "processes/laser/job/exposure_estimate.h"
#include "processes/laser/job/laser_report.h"
#include "processes/laser/job/scan_runs.h"
#include "processes/laser/task/laser_task.h"
#include "services/coordinator/algo/pipeline/check_printable.h"
#include "services/coordinator/algo/pipeline/mesh_warnings.h"
#include "services/coordinator/algo/pipeline/range_split.h"

namespace slicefarm::coordinator {
namespace {

absl::Status CheckLayer(const ExposureOutput& output, size_t layers) {
  if (output.format != OutputFormat::kDxf || static_cast<size_t>(output.layer) < layers)
    return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
      absl::StrCat("output_layer = ", output.layer, ": the part has layers 0 to ", layers - 1),
      {{"setting", "output_layer"},
       {"value", absl::StrCat(output.layer)},
       {"min", "0"},
       {"max", absl::StrCat(layers - 1)}});
}

/// A layer of the file. Its text is in a spool.
struct SpooledExposure {
  ExposedProgram program;  ///< the program without its text
  SpoolFile::Chunk text;
};

absl::Status CheckPrograms(const std::vector<SpooledExposure>& programs, size_t layers) {
  for (size_t i = 0; i < programs.size(); ++i)
    if (programs[i].program.frame.index != static_cast<int32_t>(i))
      return MakeError(
          absl::StatusCode::kInternal, Reason::kInternal,
          absl::StrCat("layer ", i, " came back as ", programs[i].program.frame.index));
  if (programs.size() == layers) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                   absl::StrCat(programs.size(), " of ", layers, " layers came back"));
}

std::vector<Copy> CopiesOf(const std::vector<PlacedCopy>& placed) {
  std::vector<Copy> copies;
  for (const PlacedCopy& copy : placed) copies.push_back({copy.object, copy.shift, 0});
  return copies;
}

class LaserJob : public PlannedJob {
 public:
  LaserJob(const ExposureStage& exposure, ExposureSettings settings, Polygon bed,
           std::string settings_text, JobReport report, SlicedJob sliced,
           std::unique_ptr<SpoolFile> spool)
      : exposure_(exposure),
        job_({std::move(settings), CopiesOf(sliced.copies)}),
        bed_(std::move(bed)),
        settings_text_(std::move(settings_text)),
        report_(std::move(report)),
        layers_(std::move(sliced.layers)),
        object_names_(std::move(sliced.object_names)),
        spool_(std::move(spool)) {}

  int32_t Weight() const override { return static_cast<int32_t>(layers_.size()); }

  absl::StatusOr<std::vector<Task>> Tasks(int slots) override {
    const std::span<const SlicedLayer> layers = layers_;
    const int32_t halo = HaloLayers(job_->settings);
    const auto ranges = SplitIntoRanges(layers, slots);
    if (absl::Status fits = CheckNeighbourhoods(layers, ranges, halo); !fits.ok()) return fits;
    std::vector<Task> tasks;
    for (const LayerRange& range : ranges) {
      const LayerRange grown = WithHalo(layers, range, halo);
      tasks.push_back(LaserTask{.range = range,
                                .layers = layers.subspan(static_cast<size_t>(grown.first),
                                                         static_cast<size_t>(grown.size())),
                                .job = job_});
    }
    ranges_.resize(tasks.size());
    return tasks;
  }

  absl::Status Take(size_t task, TaskResult result) override {
    auto& made = result.As<LaserResult>();
    ranges_[task].times = made.times;
    for (ExposedProgram& program : made.programs) {
      const auto chunk = spool_->Add(program.text);
      if (!chunk.ok()) return chunk.status();
      std::string().swap(program.text);
      ranges_[task].programs.push_back({std::move(program), *chunk});
    }
    return absl::OkStatus();
  }

  absl::StatusOr<JobOutput> Assemble(const StageCall& call) override {
    std::vector<SpooledExposure> programs;
    for (Range& range : ranges_) {
      report_.stage_times.Add(range.times);
      std::ranges::move(range.programs, std::back_inserter(programs));
    }
    if (absl::Status whole = CheckPrograms(programs, layers_.size()); !whole.ok()) return whole;
    const ExposureSummary summary = FillIn(programs);
    if (absl::Status fits = CheckRuns(job_->settings, bed_, summary.bounds); !fits.ok())
      return fits;
    if (own_.exposure.Total().lines == 0)
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                       "the outlines of all layers are too thin: with this beam_compensation no "
                       "area remains, and thin_wall_exposure adds no line");
    auto frame = Timed(report_.stage_times[Stage::kExposure], [&] {
      const ScopedSpan span(call.spans, "frame");
      return exposure_.Envelope(call, summary, job_->settings);
    });
    if (!frame.ok()) return frame.status();
    if (!frame->layer_heads.empty() && frame->layer_heads.size() != programs.size())
      return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                       absl::StrCat(frame->layer_heads.size(), " heads of ", programs.size(),
                                    " layers came back"));
    const ScopedSpan span(call.spans, "assembly");
    report_.own = std::make_unique<LaserReport>(std::move(own_));
    return JobOutput{WholeFile(*std::move(frame), programs), std::move(report_)};
  }

 private:
  /// Result of one task.
  struct Range {
    std::vector<SpooledExposure> programs;
    StageTimes times;
  };

  /// Sums up the layers, in their order.
  ExposureSummary FillIn(const std::vector<SpooledExposure>& programs) {
    ExposureReport& sum = own_.exposure;
    const double recoat_s = job_->settings.output.recoat_s;
    ExposureSummary summary;
    for (const SpooledExposure& spooled : programs) {
      sum.Add(spooled.program.report);
      own_.layer_s.push_back(recoat_s + spooled.program.report.TimeS());
      summary.layers.push_back(spooled.program.frame);
    }
    report_.layer_count = static_cast<int32_t>(programs.size());
    own_.recoating_s = recoat_s * report_.layer_count;
    report_.print_time_s = own_.recoating_s + sum.TimeS();
    report_.object_height_mm = ToMm(static_cast<double>(summary.layers.back().print_z_nm));
    summary.bounds = sum.bounds;
    summary.object_names = object_names_;
    summary.time_s = report_.print_time_s;
    summary.settings_text = settings_text_;
    return summary;
  }

  SpooledText WholeFile(ExposureEnvelope frame, const std::vector<SpooledExposure>& programs) {
    SpooledText file(std::move(spool_));
    file.Add(std::move(frame.header));
    for (size_t i = 0; i < programs.size(); ++i) {
      if (!frame.layer_heads.empty()) file.Add(std::move(frame.layer_heads[i]));
      file.Add(programs[i].text);
    }
    file.Add(std::move(frame.footer));
    return file;
  }

  const ExposureStage& exposure_;
  const Shared<ExposureJob> job_;
  const Polygon bed_;
  const std::string settings_text_;
  JobReport report_;
  LaserReport own_;
  const std::vector<SlicedLayer> layers_;
  const std::vector<std::string> object_names_;
  std::unique_ptr<SpoolFile> spool_;
  std::vector<Range> ranges_;  ///< one per task
};

}  // namespace

absl::StatusOr<std::unique_ptr<PlannedJob>> LaserProcess::Plan(const StageCall& call,
                                                               JobInput input) const {
  JobReport report;
  auto sliced = Timed(report.stage_times[Stage::kSlicing], [&] {
    const ScopedSpan span(call.spans, "slicing");
    return slicing_.Slice(call, std::move(input.meshes), input.settings.slicing);
  });
  if (!sliced.ok()) return sliced.status();
  HoldMemory(call, JobMemory::Kind::kMeshes, 0).IgnoreError();
  if (absl::Status printable = CheckPrintable(sliced->layers); !printable.ok()) return printable;
  const ExposureOutput& output = ExposureOf(input.settings).output;
  if (absl::Status there = CheckLayer(output, sliced->layers.size()); !there.ok()) return there;
  report.meshes = std::move(sliced->meshes);
  report.warnings = std::move(input.warnings);
  for (const MeshReport& mesh : report.meshes)
    std::ranges::move(MeshWarnings(mesh), std::back_inserter(report.warnings));
  auto spool = SpoolFile::Make(spool_directory_);
  if (!spool.ok()) return spool.status();
  return std::make_unique<LaserJob>(
      exposure_, std::move(ExposureOf(input.settings)), std::move(input.settings.slicing.bed),
      std::move(input.settings_text), std::move(report), *std::move(sliced), *std::move(spool));
}

absl::StatusOr<JobEstimate> LaserProcess::Estimate(const StageCall& /*call*/, SlicedJob sliced,
                                                   JobInput input,
                                                   TaskExecutor& /*executor*/) const {
  const ExposureSettings& settings = ExposureOf(input.settings);
  const SlicedOutlines outlines = {sliced.layers, sliced.copies};
  if (absl::Status fits = CheckRuns(settings, input.settings.slicing.bed, outlines); !fits.ok())
    return fits;
  return EstimateExposure(outlines, settings);
}

std::unique_ptr<JobProcess> LaserProcess::Over(const Stages& stages,
                                               const std::string& spool_directory) {
  if (stages.slicing == nullptr || stages.exposure == nullptr) return nullptr;
  return std::make_unique<LaserProcess>(*stages.slicing, *stages.exposure, spool_directory);
}

}  // namespace slicefarm::coordinator
