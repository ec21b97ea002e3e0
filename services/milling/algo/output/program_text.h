#pragma once

#include <string>
#include <string_view>

#include "services/milling/algo/motion/mill_program.h"
#include "services/milling/algo/output/gcode_dialect.h"

namespace slicefarm::milling {

/// Returns a program as G-code: mm with three decimals, modal words only where they change, arcs
/// with the centre (I, J). Each phase begins with a comment.
std::string ProgramText(const MillProgram& program, const MillingOptions& options,
                        const GcodeDialect& dialect);

/// Returns the program's G-code with comments around it: lines about tool and stock before it, and
/// the lines of `settings_text` after its end.
std::string WholeProgram(const MillingJob& job, const MillProgram& program,
                         const GcodeDialect& dialect, std::string_view settings_text);

}  // namespace slicefarm::milling
