#include "services/motion/algo/local_motion_stage.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/model/fields/field_text.h"
#include "common/stage/motion_job.h"
#include "services/motion/algo/gcode/machine_setup.h"
#include "services/motion/algo/input_check.h"
#include "services/motion/algo/layer_program.h"
#include "services/motion/algo/program_envelope.h"

namespace slicefarm::motion {
namespace {

absl::StatusOr<std::optional<MaterialField>> MaterialsOf(const MotionOptions& options) {
  if (options.material_field.empty()) return std::nullopt;
  auto field = ParseMaterialField(options.material_field);
  if (field.ok()) return *std::move(field);
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   "material_field: " + std::string(field.status().message()),
                   {{"setting", "material_field"}});
}

/// Data computed once from a job's options, for all its layers.
struct Preparation {
  MotionOptions running;  ///< options with the limits that start_gcode sets
  std::optional<MaterialField> materials;
  LayerCode code;
};

absl::StatusOr<Preparation> Prepare(const MotionJob& job) {
  const MotionOptions& options = job.options;
  if (absl::Status good = CheckOptions(options); !good.ok()) return good;
  auto materials = MaterialsOf(options);
  if (!materials.ok()) return materials.status();
  MotionOptions running = options;
  running.limits = LimitsAfterStart(options);
  auto code = LayerCode::Of(options);
  if (!code.ok()) return code.status();
  return Preparation{std::move(running), *std::move(materials), *std::move(code)};
}

class LocalMotion : public MotionStage {
 public:
  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall& call,
                                                    std::vector<OrderedLayer> layers,
                                                    const Shared<MotionJob>& job) const override {
    const absl::StatusOr<Preparation>& made = job.Once(Prepare);
    if (!made.ok()) return made.status();
    const auto& [running, materials, code] = *made;
    std::vector<LayerProgram> programs;
    programs.reserve(layers.size());
    for (OrderedLayer& layer : layers) {
      if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
      if (absl::Status good = CheckLayer(layer, job->options); !good.ok()) return good;
      auto passes =
          ProgramLayer(layer, job->facts, running, code, materials ? &*materials : nullptr);
      if (!passes.ok()) return passes.status();
      std::ranges::move(*passes, std::back_inserter(programs));
      layer.blocks = {};  // frees memory: a long range also needs memory for its text
    }
    return programs;
  }

  absl::StatusOr<ProgramEnvelope> Envelope(const StageCall& call, const ProgramSummary& summary,
                                           const MotionOptions& options) const override {
    if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
    if (absl::Status good = CheckOptions(options); !good.ok()) return good;
    return FrameProgram(summary, options);
  }
};

}  // namespace

std::unique_ptr<MotionStage> MakeLocalMotion() { return std::make_unique<LocalMotion>(); }

}  // namespace slicefarm::motion
