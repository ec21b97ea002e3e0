#include "common/gcode/custom_code.h"

#include <gtest/gtest.h>

namespace slicefarm::gcode::custom_code_test {
namespace {

TEST(LeavesModes, CommentsMessagesAndFilament) {
  for (const char* code :
       {"", "\n\n", ";AFTER_LAYER_CHANGE\n;0.4\n", "G92 E0.0\n", "  M117 layer 7 X9 ; Y\n",
        "M73 P3\nM104 S200\r\n", "M201 X3995.13 Y3995.13"})
    EXPECT_TRUE(LeavesModes(code)) << code;
}

TEST(LeavesModes, WhatMovesOrIsNotKnownMayChangeThem) {
  for (const char* code : {"G1 X1", "G92 X0 E0", "M106 S1", "M107", "M204 S100", "TIMELAPSE",
                           ";a\nG28\n;b", "G10", "M600", "SET_VELOCITY_LIMIT ACCEL=1"})
    EXPECT_FALSE(LeavesModes(code)) << code;
}

}  // namespace
}  // namespace slicefarm::gcode::custom_code_test
