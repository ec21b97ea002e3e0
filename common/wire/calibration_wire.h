#pragma once

#include "common/model/calibration_table.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm {

/// Converts the table of a calibration print to its message.
v1::CalibrationTable ToProto(const CalibrationTable& table);

/// Returns the table of a message.
CalibrationTable FromProto(const v1::CalibrationTable& proto);

}  // namespace slicefarm
