#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared.h"
#include "common/model/job_facts.h"
#include "common/model/layers/layer.h"
#include "common/model/layers/program_summary.h"
#include "common/stage/stage_call.h"

namespace slicefarm {

struct MotionJob;
struct MotionOptions;

/// Stage that writes the G-code of layers (Program) and the texts around the layers (Envelope).
class MotionStage {
 public:
  virtual ~MotionStage() = default;
  /// Returns the programs of the layers, sorted by layer, then by pass. A layer has a program for
  /// each pass that prints something in the layer. A layer without prints has one program.
  virtual absl::StatusOr<std::vector<LayerProgram>> Program(const StageCall& call,
                                                            std::vector<OrderedLayer> layers,
                                                            const Shared<MotionJob>& job) const = 0;
  virtual absl::StatusOr<ProgramEnvelope> Envelope(const StageCall& call,
                                                   const ProgramSummary& summary,
                                                   const MotionOptions& options) const = 0;
};

}  // namespace slicefarm
