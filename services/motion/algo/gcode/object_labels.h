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

/// Tells hosts and firmwares which copy is printed, so that one of them can be cancelled. By
/// gcode_label_objects: `octoprint` writes comments, `firmware` EXCLUDE_OBJECT_* for Klipper and
/// M486 for Marlin. Characters of a name that could end its line or its word are replaced.
/// Source: PrusaSlicer's labels; Klipper, "Exclude Objects"; Marlin, "M486".

/// `NAME id:2 copy 0` in comments; `NAME_(Instance_2)-5` for Klipper; else `NAME (Instance 2)`.
/// `index`: of the copy in its job.
std::string LabelOf(const CopyName& name, size_t index, const MotionOptions& options);

/// Returns true if the label of the only copy stands once, around all layers, and in none of them.
bool LabelIsAroundAll(size_t copies, const MotionOptions& options);

/// Before and after what is printed of a copy; nothing if labels are off.
void BeginCopy(const CopyName& name, size_t index, const MotionOptions& options, GcodeText& out);
void EndCopy(const CopyName& name, size_t index, const MotionOptions& options, GcodeText& out);

/// What the head of the file says of all copies.
void DefineCopies(std::span<const CopySummary> copies, const MotionOptions& options,
                  GcodeText& out);

}  // namespace slicefarm::motion
