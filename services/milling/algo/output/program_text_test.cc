#include "services/milling/algo/output/program_text.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "common/base/temp_directory_test.h"
#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::program_text_test {
namespace {

TEST(ProgramText, WritesWhatChanges) {
  const MillProgram program{
      .moves = {{.to_mm = {1, 2, 9}},
                {.to_mm = {1, 2, 4.5}},
                {.kind = MoveKind::kLine, .to_mm = {1, 2, 3}, .feed_mm_min = 200},
                {.kind = MoveKind::kLine, .to_mm = {5, 2, 3}, .feed_mm_min = 800},
                {.kind = MoveKind::kCounterClockwise,
                 .phase = MillPhase::kFinishing,
                 .to_mm = {5, 6, 3},
                 .centre_mm = {5, 4},
                 .feed_mm_min = 800},
                {.phase = MillPhase::kFinishing, .to_mm = {5, 6, 9}}},
      .safe_z_mm = 9};
  const std::string text =
      ProgramText(program, OptionsFor("cyl:2"), *DialectOf(MillDialect::kGrbl));
  EXPECT_NE(text.find("(roughing)\n"
                      "G0 X1.000 Y2.000\n"
                      "Z4.500\n"
                      "G1 Z3.000 F200.000\n"
                      "X5.000 F800.000\n"
                      "(finishing)\n"
                      "G3 X5.000 Y6.000 I0.000 J2.000\n"
                      "G0 Z9.000\n"),
            text.npos)
      << text;
}

/// LinuxCNC's own interpreter must accept the program, with arcs.
TEST(ProgramText, PassesTheInterpreterOfLinuxCnc) {
  if (std::system("command -v rs274 > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "rs274 (package linuxcnc-uspace) is not installed";
  const TempDirectory directory;
  const std::string table = directory.path() + "/tool.tbl";
  std::ofstream(table) << "T1 P1 D2 Z0\n";
  for (const std::string_view cutter : {"cyl:1.5", "ball:1.5"}) {
    const std::string path = directory.path() + "/program.ngc";
    std::ofstream(path) << TextOf(JobOf(PocketPart().Mesh(), OptionsFor(cutter)));
    const std::string log = directory.path() + "/log";
    const std::string command = "rs274 -g -t " + table + " " + path + " > " + log + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::ifstream in(log);
    const std::string said((std::istreambuf_iterator<char>(in)), {});
    EXPECT_NE(said.find("PROGRAM_END"), said.npos) << said.substr(said.size() - 300);
  }
}

}  // namespace
}  // namespace slicefarm::milling::program_text_test
