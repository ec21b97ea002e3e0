#pragma once

#include <string>

#include "services/milling/algo/motion/mill_program.h"
#include "services/milling/algo/output/gcode_dialect.h"

namespace slicefarm::milling {

/// A program as G-code: mm with three decimals, modal words once, arcs by their centres. A comment
/// begins each stage.
std::string ProgramText(const MillProgram& program, const MillingOptions& options,
                        const GcodeDialect& dialect);

}  // namespace slicefarm::milling
