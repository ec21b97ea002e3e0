#include "services/motion/algo/local_motion_stage.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/model/fields/field_text.h"
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

class LocalMotion : public MotionStage {
 public:
  absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall& call,
                                                    std::vector<OrderedLayer> layers,
                                                    const JobFacts& facts,
                                                    const MotionOptions& options) const override {
    if (absl::Status good = CheckOptions(options); !good.ok()) return good;
    const auto materials = MaterialsOf(options);
    if (!materials.ok()) return materials.status();
    MotionOptions running = options;
    running.limits = LimitsAfterStart(options);
    const auto code = LayerCode::Of(options);
    if (!code.ok()) return code.status();
    std::vector<LayerProgram> programs;
    programs.reserve(layers.size());
    for (OrderedLayer& layer : layers) {
      if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
      if (absl::Status good = CheckLayer(layer, options); !good.ok()) return good;
      auto passes = ProgramLayer(layer, facts, running, *code, *materials ? &**materials : nullptr);
      if (!passes.ok()) return passes.status();
      std::ranges::move(*passes, std::back_inserter(programs));
      layer.blocks = {};  // a range may be long: its paths make room for its text
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
