#pragma once

#include <string_view>
#include <vector>

#include "common/gcode/archive/archived_plate.h"
#include "common/model/layers/program_summary.h"
#include "processes/fdm/model/fdm_settings.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Removes the pictures that are not for the head of the G-code, and returns them.
std::vector<Thumbnail> TakePlatePictures(std::vector<Thumbnail>& thumbnails);

/// Returns the plate of a .gcode.3mf archive without its program. `report`: complete report.
/// `pictures`: result of TakePlatePictures. The project's settings are the ones of
/// gcode::kProjectKeys.
gcode::ArchivedPlate ArchivedPlateOf(const ProgramSummary& summary, const PrintTimes& times,
                                     const JobReport& report, const FdmSettings& settings,
                                     std::vector<Thumbnail> pictures);

}  // namespace slicefarm::coordinator
