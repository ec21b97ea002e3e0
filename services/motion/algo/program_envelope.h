#pragma once

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/model/layers/program_summary.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// What stands around the layers, and what the whole print takes.
///
/// The prologue heats up, runs the start G-code and leaves the canonical state that layers begin
/// in: millimetres, absolute coordinates, relative extrusion, filament retracted. The epilogue
/// begins in that state. Times: those of the whole program's look-ahead (print_clock.h), its own
/// G-code included; heating by the settings' rates. The prefix of a pass's first layer brings the
/// nozzle there over all that stands (pass_change.h); end G-code begins above all of it. Errors:
/// those of the templates (template_run.h). REQUIRES: CheckOptions holds.
absl::StatusOr<ProgramEnvelope> FrameProgram(const ProgramSummary& summary,
                                             const MotionOptions& options);

}  // namespace slicefarm::motion
