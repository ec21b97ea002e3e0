#pragma once

#include <string>
#include <string_view>

#include "services/milling/algo/motion/mill_program.h"
#include "services/milling/algo/output/gcode_dialect.h"

namespace slicefarm::milling {

/// A program as G-code: mm with three decimals, modal words once, arcs by their centres. A comment
/// begins each phase.
std::string ProgramText(const MillProgram& program, const MillingOptions& options,
                        const GcodeDialect& dialect);

/// The same between lines of comment: tool and stock before it, the lines of `settings_text` after
/// its end.
std::string WholeProgram(const MillingJob& job, const MillProgram& program,
                         const GcodeDialect& dialect, std::string_view settings_text);

}  // namespace slicefarm::milling
