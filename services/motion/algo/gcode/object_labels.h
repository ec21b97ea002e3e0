#pragma once

#include <span>
#include <string>

#include "common/gcode/gcode_text.h"
#include "common/model/job_facts.h"
#include "common/model/layers/program_summary.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

// Labels tell hosts and firmwares which copy is printed, so that one copy can be cancelled. With
// gcode_label_objects = `octoprint` labels are comments. With `firmware` they are EXCLUDE_OBJECT_*
// for Klipper and M486 for Marlin. Characters of a name that could end its line or its word are
// replaced. Source: PrusaSlicer's labels; Klipper, "Exclude Objects"; Marlin, "M486".

/// Returns the label of a copy: `NAME id:2 copy 0` in comments, `NAME_(Instance_2)-5` for Klipper,
/// otherwise `NAME (Instance 2)`. `index`: index of the copy in its job.
std::string LabelOf(const CopyName& name, size_t index, const MotionOptions& options);

/// Returns true if the job has one copy and the firmware wants its label once, around all layers,
/// instead of in each layer.
bool LabelIsAroundAll(size_t copies, const MotionOptions& options);

/// Writes the lines before a copy; nothing if labels are off.
void BeginCopy(const CopyName& name, size_t index, const MotionOptions& options, GcodeText& out);
/// Writes the lines after a copy; nothing if labels are off.
void EndCopy(const CopyName& name, size_t index, const MotionOptions& options, GcodeText& out);

/// Writes the definitions of all copies for the head of the file.
void DefineCopies(std::span<const CopySummary> copies, const MotionOptions& options,
                  GcodeText& out);

}  // namespace slicefarm::motion
