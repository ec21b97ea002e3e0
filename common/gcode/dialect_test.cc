#include "common/gcode/dialect.h"

#include <gtest/gtest.h>

#include <string>

namespace slicefarm::gcode::dialect_test {
namespace {

std::string DwellOf(Controller controller, double us) {
  GcodeText out;
  WriteDwell(DialectOf(controller), us, out);
  return out.Take();
}

TEST(Dialect, DwellsInItsUnit) {
  EXPECT_EQ(DwellOf(Controller::kMarlin, 1'001), "G4 P2\n");
  EXPECT_EQ(DwellOf(Controller::kGrbl, 1'001), "G4 P0.001001\n");
  EXPECT_EQ(DwellOf(Controller::kLinuxCnc, 3e6), "G4 P3\n");
}

TEST(Dialect, SaysWhatItsControllerKnows) {
  for (const auto& [controller, name, units, end] :
       {std::tuple(Controller::kMarlin, "Marlin", "G21\nG90\n", ""),
        std::tuple(Controller::kGrbl, "grbl", "G21\nG90\nG94\n", "M2\n"),
        std::tuple(Controller::kLinuxCnc, "LinuxCNC", "G21\nG90\nG94\n", "M2\n")}) {
    GcodeText head, tail;
    WriteUnits(DialectOf(controller), head);
    WriteProgramEnd(DialectOf(controller), tail);
    EXPECT_EQ(DialectOf(controller).name, name);
    EXPECT_EQ(head.text(), units) << name;
    EXPECT_EQ(tail.text(), end) << name;
  }
}

}  // namespace
}  // namespace slicefarm::gcode::dialect_test
