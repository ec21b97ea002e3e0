#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/base/spooled_text.h"
#include "common/gcode/substitutions.h"
#include "common/model/layers/layer.h"
#include "common/model/layers/program_summary.h"

namespace slicefarm::coordinator {

/// A layer's program whose text is in a spool, so that a job may have more of it than fits into
/// memory.
struct SpooledProgram {
  LayerProgram program;  ///< without its text
  SpoolFile::Place text;
};

/// Errors: the spool's.
absl::StatusOr<std::vector<SpooledProgram>> Spooled(std::vector<LayerProgram> programs,
                                                    SpoolFile& spool);

/// All programs in the order of printing: by pass, then bottom up. `programs` come in the order of
/// their layers. Errors: INTERNAL unless there are programs of `layer_count` layers, each with the
/// passes that its predecessor has or fewer; NOTHING_TO_PRINT if none has a bead.
absl::StatusOr<std::vector<SpooledProgram>> InPrintOrder(std::vector<SpooledProgram> programs,
                                                         size_t layer_count);

/// What the frame of the job is made of.
ProgramSummary Summarize(const std::vector<SpooledProgram>& programs);

/// Returns head, prologue, prefixes and programs, epilogue, tail. `substitutions` are made in all
/// of it except head and tail, layer by layer; the text that they make of layers goes to `spool`,
/// which holds the programs. Errors: REQUEST_TOO_LARGE where substitutions make a text more than
/// twice as long and limits::kMaxExpandedBytes longer, or the whole longer than
/// limits::kMaxProgramBytes; those of the spool; Cancelled.
absl::StatusOr<SpooledText> WholeProgram(ProgramEnvelope frame,
                                         const std::vector<SpooledProgram>& programs,
                                         const gcode::Substitutions& substitutions,
                                         std::unique_ptr<SpoolFile> spool,
                                         const CancelToken& cancel);

}  // namespace slicefarm::coordinator
