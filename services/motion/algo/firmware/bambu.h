#pragma once

#include "services/motion/algo/firmware/firmware.h"

namespace slicefarm::motion {

/// Bambu Lab's printers: Marlin's commands, with the comments and labels of Bambu Studio.
const Firmware& Bambu();

/// Writes the block of facts with which G-code of Bambu Studio begins. `program`: line that names
/// the program, or empty. Readers of .gcode.3mf archives search for this block in programs of all
/// firmwares.
void WriteHeaderBlock(std::string_view program, const PrintFacts& facts, GcodeText& out);

}  // namespace slicefarm::motion
