#pragma once

#include <optional>
#include <string>

#include "common/model/layers/program_summary.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Returns the first lines of a file: the program and the content. No clock is used: the date is
/// the date of the release.
std::string MetadataHead(const ProgramSummary& summary);

/// Returns the last lines of a file, for printer hosts: filament used, times, layers, then the
/// settings between "; prusaslicer_config = begin" and "end". `silent`: times in the machine's
/// silent mode, if it has one. If the settings lack a key that hosts search for, it is added from
/// the options. Text in names or settings cannot end its line. Source: PrusaSlicer's keys, as read
/// by Moonraker, PrusaLink and OctoPrint's plug-ins.
std::string MetadataTail(const MotionOptions& options, const ProgramSummary& summary,
                         const PrintTimes& times, const std::optional<PrintTimes>& silent = {});

}  // namespace slicefarm::motion
