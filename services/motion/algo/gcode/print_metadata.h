#pragma once

#include <optional>
#include <string>

#include "common/model/layers/program_summary.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// First lines of a file: who made it, and what is in it. No clock: the date is that of the
/// release.
std::string MetadataHead(const ProgramSummary& summary);

/// Last lines of a file, for printer hosts: filament used, times (`silent`: in the machine's silent
/// mode, if it has one), layers, then the settings between
/// "; prusaslicer_config = begin" and "end". Keys that hosts look for and the settings do not have
/// are added from the options. Nothing in names or settings can end its line. Source: PrusaSlicer's
/// keys, as read by Moonraker, PrusaLink and OctoPrint's plug-ins.
std::string MetadataTail(const MotionOptions& options, const ProgramSummary& summary,
                         const PrintTimes& times,
                         const std::optional<PrintTimes>& silent = {});

}  // namespace slicefarm::motion
