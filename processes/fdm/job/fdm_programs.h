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

/// The program of a layer with its text in a spool, so that the programs of a job may exceed the
/// memory.
struct SpooledProgram {
  LayerProgram program;  ///< the program without its text
  SpoolFile::Chunk text;
};

/// Moves the texts of the programs to the spool. Errors: any error of the spool.
absl::StatusOr<std::vector<SpooledProgram>> Spooled(std::vector<LayerProgram> programs,
                                                    SpoolFile& spool);

/// Returns all programs in the order of printing: sorted by pass (see Copy::pass), within a pass
/// from the bottom up. `programs` are sorted by layer. Errors:
/// - INTERNAL unless there are programs of `layer_count` layers, and each layer has only passes
///   that the layer before it has.
/// - NOTHING_TO_PRINT if no program has a bead.
absl::StatusOr<std::vector<SpooledProgram>> InPrintOrder(std::vector<SpooledProgram> programs,
                                                         size_t layer_count);

/// Returns the data of the programs that the texts around the layers need (ProgramEnvelope).
ProgramSummary Summarize(const std::vector<SpooledProgram>& programs);

/// Adds the totals of copies in the programs to the copies of the job. Errors: INTERNAL if a
/// program has a copy that the job does not have.
absl::Status AddCopyUses(const std::vector<SpooledProgram>& programs,
                         std::vector<CopySummary>& copies);

/// Returns the whole text: head, prologue, prefixes and programs, epilogue, tail. `substitutions`
/// apply layer by layer to the whole text except head and tail. The substituted text of layers is
/// written to `spool`, which contains the programs. Errors:
/// - REQUEST_TOO_LARGE if a substituted text exceeds twice the original length plus
///   limits::kMaxExpandedBytes, or the whole exceeds limits::kMaxProgramBytes.
/// - Any error of the spool; Cancelled.
absl::StatusOr<SpooledText> WholeProgram(ProgramEnvelope frame,
                                         const std::vector<SpooledProgram>& programs,
                                         const gcode::Substitutions& substitutions,
                                         std::unique_ptr<SpoolFile> spool,
                                         const CancelToken& cancel);

}  // namespace slicefarm::coordinator
