#include "services/motion/algo/program/program_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "services/motion/algo/firmware/bambu.h"
#include "services/motion/algo/firmware/klipper.h"
#include "services/motion/algo/firmware/marlin.h"
#include "services/motion/algo/firmware/reprap.h"

namespace slicefarm::motion::program_check_test {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr char kHead[] =
    "M104 S200\nG28\nG21\nG90\nM83\nG1 E-.8 F2100\n"
    ";LAYER_CHANGE\n;Z:0.2\nG1 Z.2 F600\nG1 X20 Y20 F7800\nG1 E.8 F2100\n;TYPE:Perimeter\n";
constexpr char kTail[] = "G1 E-.8 F2100\n;TYPE:Custom\nM104 S0\nM84\n";

CheckSetup Machine() {
  CheckSetup setup;
  setup.bed = {{0, 0}, {FromMm(200), 0}, {FromMm(200), FromMm(200)}, {0, FromMm(200)}};
  setup.max_height_mm = 180;
  return setup;
}

std::vector<Finding> Check(const std::string& body, const Firmware& firmware = Marlin2()) {
  return CheckProgram(absl::StrCat(kHead, body, kTail), firmware, Machine()).findings;
}

/// Matches one finding, on the first line of the body.
auto One(const std::string& text) {
  return ElementsAre(
      testing::AllOf(Field(&Finding::line, 13), Field(&Finding::text, HasSubstr(text))));
}

TEST(CheckProgram, AProperProgramPasses) {
  for (const auto firmware : {Klipper, Marlin2, RepRap}) {
    EXPECT_THAT(Check("G1 X40 E.66 F1800\nG1 E-.8 F2100\nG1 X50 F7800\nG1 E.8 F2100\n"
                      "G1 X60 E.33 F1800\nG3 X50 Y30 I-10 E.5\n",
                      firmware()),
                IsEmpty());
  }
}

TEST(CheckProgram, WordsAndCommands) {
  EXPECT_THAT(Check("G1 X4 X5\n"), One("a word is repeated"));
  EXPECT_THAT(Check("G1 X4..5\n"), One("cannot be read"));
  EXPECT_THAT(Check("G1 X\n"), One("X has no number"));
  EXPECT_THAT(Check("G1 X30 Q2\n"), One("no word Q"));
  EXPECT_THAT(Check("G1 X30 F0\n"), One("F0"));
  EXPECT_THAT(Check("M1234\n"), One("M1234"));
  EXPECT_THAT(Check("M205 X8\n", Klipper()), One("M205"));
  EXPECT_THAT(Check("M900 K.1\n", RepRap()), One("M900"));
  EXPECT_THAT(Check("M567 P0 E.8:.2\nM950 H0 C\"out0\"\n", RepRap()), IsEmpty());
  EXPECT_THAT(Check("M92 E420:420\n"), One("does not read lists"));
  EXPECT_THAT(Check("SET_VELOCITY_LIMIT ACCEL=3000\n"), One("SET_VELOCITY_LIMIT"));
  EXPECT_THAT(Check("SET_VELOCITY_LIMIT ACCEL=3000\n", Klipper()), IsEmpty());
  EXPECT_THAT(Check("MY_MACRO A=1\n", Klipper()), One("MY_MACRO"));
  EXPECT_THAT(Check(";TYPE:Custom\nMY_MACRO A=1\n", Klipper()), IsEmpty());
}

TEST(CheckProgram, OutsideOfTheMachine) {
  EXPECT_THAT(Check("G1 X200.5 F600\n"), One("0.500 mm outside"));
  EXPECT_THAT(Check("G1 Y-1 F600\n"), One("outside"));
  EXPECT_THAT(Check("G1 Z181 F600\n"), One("outside"));
  EXPECT_THAT(Check("G1 Z-.1 F600\n"), One("outside"));
  EXPECT_THAT(Check("G3 X190 Y30 I0 J5\n"), testing::Not(IsEmpty()));
  EXPECT_THAT(Check(";TYPE:Custom\nG1 Y-3 F600\n"), IsEmpty()) << "start G-code primes there";
}

TEST(CheckProgram, TheNozzleIsLiftedWhereStartGcodeHasLeftIt) {
  const std::string start =
      "M104 S200\nG28\nG90\nM83\n;TYPE:Custom\nG1 X51 Y-4 F600\n;LAYER_CHANGE\n";
  const auto findings = [&](const std::string& rest) {
    return CheckProgram(start + rest, Marlin2(), Machine()).findings;
  };
  EXPECT_THAT(findings("G1 Z.8\nG1 X20 Y20\n"), IsEmpty());
  EXPECT_THAT(findings("G1 X52\n"), ElementsAre(Field(&Finding::text, HasSubstr("outside"))));
  EXPECT_THAT(findings("G1 Z-.8\n"), ElementsAre(Field(&Finding::text, HasSubstr("outside"))));
}

TEST(CheckProgram, CustomCodeOfVendors) {
  EXPECT_THAT(Check(";TYPE:Custom\nM970.3 Q0 A7 Q0\nG380 S2 Z30\n", Bambu()), IsEmpty());
  EXPECT_THAT(Check("M970.3 Q0 A7 Q0\n", Bambu()), One("a word is repeated"));
  EXPECT_THAT(Check(";TYPE:Custom\nG1 X4 X5\n", Bambu()),
              ElementsAre(Field(&Finding::text, HasSubstr("a word is repeated"))));
}

TEST(CheckProgram, Beads) {
  EXPECT_THAT(Check("G1 X21 E.3 F600\n"), One("a section of 0.72"));
  EXPECT_THAT(Check("G1 X20.01 E.1 F600\n"), IsEmpty()) << "so little passes";
}

TEST(CheckProgram, Retractions) {
  EXPECT_THAT(Check("G1 X30 E.3 F600\nG1 E-.8\nG1 X40\nG1 X50 E.3\nG1 E.8\n"),
              ElementsAre(Field(&Finding::text, HasSubstr("retracted by 0.800")),
                          Field(&Finding::text, HasSubstr("without a preceding retraction"))));
  EXPECT_THAT(Check("G1 X30 E.3 F600\nG1 E60\nG1 E-60\n", Klipper()), testing::Not(IsEmpty()));
  EXPECT_THAT(Check("G11\n"), One("G11 without"));
}

TEST(CheckProgram, Arcs) {
  EXPECT_THAT(Check("G3 X30 Y30 I10 J.1 E.5 F600\n"), One("an arc begins"));
  EXPECT_THAT(Check("G3 X30 Y30 E.5 F600\n"), testing::Not(IsEmpty()));
  EXPECT_THAT(Check("G3 X30 Y30 R10 E.5 F600\n"), IsEmpty());
  EXPECT_THAT(Check("G3 X30 Y30 R10 E.5 F600\n", Klipper()), One("by radius"));
}

TEST(CheckProgram, Cold) {
  const ProgramReport report = CheckProgram("G1 X9 E.1\nG1 X19 E.1\n", Marlin2(), Machine());
  EXPECT_THAT(report.findings, ElementsAre(Field(&Finding::text, HasSubstr("temperature"))));
}

TEST(CheckProgram, SumsOfFilament) {
  EXPECT_THAT(Check("G1 X40 E.66 F1800\n; filament used [mm] = 0.66\n"), IsEmpty());
  EXPECT_THAT(Check("G1 X40 E.66 F1800\n; filament used [mm] = 0.80\n"),
              ElementsAre(Field(&Finding::line, 14)));
}

TEST(CheckProgram, TellsNoMoreThanItsMost) {
  std::string many;
  for (int i = 0; i < 2000; ++i) many += "M1234\n";
  const ProgramReport report = CheckProgram(kHead + many, Marlin2(), Machine());
  EXPECT_EQ(report.findings.size(), kMostFindings);
  EXPECT_EQ(report.found, 2000);
}

}  // namespace
}  // namespace slicefarm::motion::program_check_test
