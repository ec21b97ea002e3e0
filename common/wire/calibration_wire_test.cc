#include "common/wire/calibration_wire.h"

#include <gtest/gtest.h>

namespace slicefarm::calibration_wire_test {
namespace {

TEST(CalibrationWire, KeepsEachField) {
  const CalibrationTable table = {"flow",
                                  "%",
                                  "extrusion_multiplier",
                                  {{"-5", 0.95, 0, 0, "flow -5"}, {"+5", 1.05, 1.5, 6.5, "tower"}}};
  EXPECT_EQ(FromProto(ToProto(table)), table);
  EXPECT_EQ(FromProto(v1::CalibrationTable()), CalibrationTable());
}

}  // namespace
}  // namespace slicefarm::calibration_wire_test
