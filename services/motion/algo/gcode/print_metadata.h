#pragma once

#include <optional>
#include <string>

#include "common/model/layers/program_summary.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Returns the first lines of a file: the slicer's name and version, and the file's content. The
/// date in it is the release date of slicefarm, so that the same input gives the same bytes.
std::string MetadataHead(const ProgramSummary& summary);

/// Returns the settings that readers of .gcode.3mf archives search for near the head, by their
/// names in Bambu Studio (common/gcode/archive/project_keys.h).
std::string ArchiveConfigBlock(const MotionOptions& options, const ProgramSummary& summary);

/// Returns the last lines of a file, for printer hosts: filament used, times, layers, then the
/// settings between "; prusaslicer_config = begin" and "end". `silent`: times in the machine's
/// silent mode, if it has one. A key that hosts search for and that the settings lack is added with
/// its value in the options. Line breaks in names and settings are escaped. Source: PrusaSlicer's
/// keys, as read by Moonraker, PrusaLink and OctoPrint's plug-ins.
std::string MetadataTail(const MotionOptions& options, const ProgramSummary& summary,
                         const PrintTimes& times, const std::optional<PrintTimes>& silent = {});

}  // namespace slicefarm::motion
