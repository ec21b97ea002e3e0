#pragma once

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/model/layers/program_summary.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Returns the text around the layers, and the cost of the whole print.
///
/// The prologue heats up, runs the start G-code and ends in the canonical state for layers:
/// millimetres, absolute coordinates, relative extrusion, filament retracted. The epilogue begins
/// in this state. Times are the look-ahead of the whole program (print_clock.h), including the text
/// around the layers. Heating times follow from the rates in the settings. The prefix of a pass's
/// first layer moves the nozzle to this layer, above everything that is printed (pass_change.h).
/// The end G-code begins above the whole print. Errors: any error of the templates
/// (template_run.h). REQUIRES: CheckOptions succeeds.
absl::StatusOr<ProgramEnvelope> FrameProgram(const ProgramSummary& summary,
                                             const MotionOptions& options);

}  // namespace slicefarm::motion
