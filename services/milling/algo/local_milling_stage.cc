#include "services/milling/algo/local_milling_stage.h"

#include <fmt/core.h>

#include <optional>
#include <utility>

#include "common/base/error.h"
#include "services/milling/algo/motion/mill_program.h"
#include "services/milling/algo/output/level_svg.h"
#include "services/milling/algo/output/mill_report.h"
#include "services/milling/algo/output/program_text.h"
#include "services/milling/algo/strategy/mill_steps.h"

namespace slicefarm::milling {
namespace {

absl::Status NoSuchStep(std::string_view what) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, what);
}

absl::Status CheckPicture(const MillingJob& job, const MillSettings& settings) {
  if (settings.format != MillFormat::kSvg || settings.output_step < std::ssize(job.steps))
    return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("output_step = {}: the job has steps 0 to {}", settings.output_step,
                               job.steps.size() - 1),
                   {{"setting", "output_step"},
                    {"value", fmt::format("{}", settings.output_step)},
                    {"min", "0"},
                    {"max", fmt::format("{}", job.steps.size() - 1)}});
}

/// Checks that the steps are complete: a program needs all steps, a picture only the step that it
/// shows.
absl::Status CheckSteps(const MillingJob& job, const MillSettings& settings,
                        const std::vector<MilledStep>& steps) {
  const bool picture = settings.format == MillFormat::kSvg;
  const size_t first = picture ? static_cast<size_t>(settings.output_step) : 0;
  const size_t count = picture ? 1 : job.steps.size();
  if (steps.size() != count) return NoSuchStep("not all steps are there");
  for (size_t i = 0; i < count; ++i)
    if (steps[i].step != job.steps[first + i]) return NoSuchStep("a step is none of the job's");
  return absl::OkStatus();
}

TriangleMesh InMm(const IndexedMesh& mesh) {
  TriangleMesh in_mm;
  in_mm.points_mm.reserve(mesh.vertices.size());
  for (const Vertex& v : mesh.vertices)
    in_mm.points_mm.push_back({ToMm(static_cast<double>(v.x)), ToMm(static_cast<double>(v.y)),
                               ToMm(static_cast<double>(v.z))});
  in_mm.triangles = mesh.triangles;
  return in_mm;
}

absl::StatusOr<MillingJob> Prepare(const MillInput& input) {
  std::optional<TriangleMesh> stock;
  if (!input.stock.triangles.empty()) stock = InMm(input.stock);
  return PrepareMilling(InMm(input.part), std::move(stock), input.settings.how);
}

/// Returns the job, prepared once for all calls. The preparation ignores cancellation, because
/// other calls use its result too.
absl::StatusOr<const MillingJob*> JobOf(const StageCall& call, const Shared<MillInput>& input) {
  if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
  const absl::StatusOr<MillingJob>& job = input.Once(Prepare);
  if (!job.ok()) return job.status();
  return &*job;
}

class LocalMilling : public MillingStage {
 public:
  absl::StatusOr<MillLayout> LayOut(const StageCall& call,
                                    const Shared<MillInput>& input) const override {
    const auto job = JobOf(call, input);
    if (!job.ok()) return job.status();
    if (absl::Status there = CheckPicture(**job, input->settings); !there.ok()) return there;
    return MillLayout{(*job)->steps, StepWeights(**job), (*job)->part_box, (*job)->stock_box};
  }

  absl::StatusOr<std::vector<MilledStep>> Mill(const StageCall& call,
                                               const Shared<MillInput>& input,
                                               StepRange range) const override {
    const auto job = JobOf(call, input);
    if (!job.ok()) return job.status();
    if (range.first < 0 || range.first > range.last || range.last > std::ssize((*job)->steps))
      return NoSuchStep("the job has no such range of steps");
    return MillSteps(**job, static_cast<size_t>(range.first), static_cast<size_t>(range.last),
                     call.cancel, call.threads);
  }

  absl::StatusOr<MilledProgram> Assemble(const StageCall& call, const Shared<MillInput>& input,
                                         std::vector<MilledStep> steps,
                                         std::string_view settings_text) const override {
    const auto job = JobOf(call, input);
    if (!job.ok()) return job.status();
    if (absl::Status there = CheckPicture(**job, input->settings); !there.ok()) return there;
    if (absl::Status sound = CheckSteps(**job, input->settings, steps); !sound.ok()) return sound;
    if (input->settings.format == MillFormat::kSvg)
      return MilledProgram{LevelSvg(**job, steps.front()), {}};
    const auto program = AssembleProgram(**job, steps, call.cancel);
    if (!program.ok()) return program.status();
    absl::StatusOr<MillReport> report = ReportOf(**job, *program, call.cancel, call.threads);
    if (!report.ok()) return report.status();
    return MilledProgram{
        WholeProgram(**job, *program, *DialectOf(input->settings.dialect), settings_text),
        *std::move(report)};
  }
};

}  // namespace

std::unique_ptr<MillingStage> MakeLocalMilling() { return std::make_unique<LocalMilling>(); }

}  // namespace slicefarm::milling
