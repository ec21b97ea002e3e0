// Runs the program as a process. Tests the files and output of each command, and exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "services/cli/console/program_fixture_test.h"

namespace slicefarm::lab::lab_program_test {
namespace {

using cli::Arguments;
using cli::ExitCode;
using cli::Outcome;
using cli::Program;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(Program, HelpNamesEveryCommand) {
  const Outcome help = Run({"--help"});
  EXPECT_EQ(help.code, ExitCode::kOk);
  for (const char* command :
       {"beads", "fill", "decompose", "tsp", "flatten", "waterline", "support-lab"}) {
    EXPECT_THAT(help.out, HasSubstr(std::string("\n  ") + command + " "));
    const Outcome own = Run({command, "--help"});
    EXPECT_EQ(own.code, ExitCode::kOk) << command;
    EXPECT_THAT(own.out, HasSubstr(std::string("slicefarm-lab ") + command)) << command;
  }
  EXPECT_THAT(Run({"--version"}).out, StartsWith("slicefarm-lab "));
  const Outcome unknown = Run({"slice"});
  EXPECT_EQ(unknown.code, ExitCode::kUsage);
  EXPECT_THAT(unknown.err, HasSubstr("slicefarm-lab has no command 'slice'"));
}

/// A comb of 3 teeth: the shortest tour has 12 edges of length 1.
constexpr char kComb[] =
    "NAME : comb\nTYPE : TSP\nDIMENSION : 12\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n"
    "1 0 0\n2 2 1\n3 1 0\n4 1 1\n5 2 0\n6 3 0\n7 0 1\n8 3 1\n9 4 0\n10 4 1\n11 5 1\n12 5 0\nEOF\n";

TEST_F(Program, FindsAShortTour) {
  Put("comb.tsp", kComb);
  const Arguments tsp = {"tsp", Path("comb.tsp"), "--seconds",      "1", "--seed",
                         "3",   "--tour",         Path("comb.tour")};
  const Outcome outcome = Run(tsp);
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("name comb\nn 12\nlength 12\nlower_bound 12\nseconds "));
  const std::string tour = Text("comb.tour");
  EXPECT_THAT(tour, StartsWith("NAME : comb\nTYPE : TOUR\nDIMENSION : 12\nTOUR_SECTION\n"));
  EXPECT_EQ(Run(tsp).code, ExitCode::kOk);
  EXPECT_EQ(Text("comb.tour"), tour) << "the same seed";
  for (const char* start : {"nearest", "greedy", "insertion", "christofides"}) {
    const Outcome first =
        Run({"tsp", Path("comb.tsp"), "--start", start, "--moves", "none", "--local", "--bounds"});
    EXPECT_EQ(first.code, ExitCode::kOk) << start << first.err;
    EXPECT_THAT(first.out, HasSubstr("\nspanning_tree 11\nodd_matching ")) << start;
  }
  EXPECT_EQ(Run({"tsp", Path("comb.tsp"), "--start", "best"}).code, ExitCode::kUsage);
  EXPECT_EQ(Run({"tsp", Path("comb.tsp"), "--tour", Path("no/comb.tour")}).code,
            ExitCode::kOutputFailed);
  EXPECT_EQ(Run({"tsp", Path("none.tsp")}).code, ExitCode::kUsage);
  Put("bad.tsp", "TYPE : TSP\nDIMENSION : x\n");
  const Outcome bad = Run({"tsp", Path("bad.tsp")});
  EXPECT_EQ(bad.code, ExitCode::kUsage);
  EXPECT_THAT(bad.err, HasSubstr("bad.tsp: line "));
}

TEST_F(Program, DecomposesAPolygon) {
  Put("l.poly", "1\n6 out\n0 0\n2.5 0\n2.5 1\n1 1\n1 2\n0 2\n1 2 3 4 5 6\n");
  for (const char* method : {"bian", "optimal", "approximate"}) {
    const Outcome outcome =
        Run({"decompose", Path("l.poly"), "-o", Path("pieces.txt"), "--method", method});
    ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
    EXPECT_THAT(outcome.out, StartsWith("pieces 2\nreflex 1\n"));
    for (const char* row : {"min_angle_deg ", "worst_shape ", "seconds "})
      EXPECT_THAT(outcome.out, HasSubstr(row));
    EXPECT_THAT(Text("pieces.txt"), HasSubstr("2.5 0"));
  }
  Put("crossed.poly", "0 0\n1 0\n0 1\n1 1\n");
  EXPECT_EQ(Run({"decompose", Path("crossed.poly"), "-o", Path("none.txt")}).code,
            ExitCode::kUsage);
  EXPECT_FALSE(std::filesystem::exists(Path("none.txt")));
}

/// A rectangle of 10 x 4 mm, as outlines.
constexpr char kOutline[] = "0 0\n4\n0 0\n10 0\n10 4\n0 4\n";

TEST_F(Program, LaysBeadsAndInfillInOutlines) {
  std::filesystem::create_directory(Path("in"));
  Put("in/box.txt", kOutline);
  const Outcome beads = Run({"beads", Path("in"), "-o", Path("beads")});
  ASSERT_EQ(beads.code, ExitCode::kOk) << beads.err;
  EXPECT_THAT(beads.out, StartsWith("outlines 1\nseconds "));
  EXPECT_THAT(Text("beads/box.txt"), StartsWith("0 0 1 "));
  const Outcome fill = Run({"fill", Path("in"), "-o", Path("paths"), "--quality"});
  ASSERT_EQ(fill.code, ExitCode::kOk) << fill.err;
  for (const char* row : {"outlines 1\n", "\narea_mm2 40.0\n", "\ndensity_got "})
    EXPECT_THAT(fill.out, HasSubstr(row));
  EXPECT_GT(Text("paths/box.txt").size(), 50u);
  EXPECT_EQ(Run({"fill", Path("in"), "-o", Path("paths"), "--pattern", "none"}).code,
            ExitCode::kUsage);
}

TEST_F(Program, FlattensACube) {
  const Outcome outcome = Run({"flatten", Path("cube.obj"), "-o", Path("uv.obj")});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("faces 12\nseam_edges "));
  EXPECT_THAT(Text("uv.obj"), HasSubstr("\nvt "));
  EXPECT_NE(Run({"flatten", Path("cube.obj"), "-o", Path("no.obj"), "--no-seam"}).code,
            ExitCode::kOk);
  EXPECT_FALSE(Exists("no.obj"));
}

TEST_F(Program, FindsLoopsOfACutter) {
  const Outcome outcome = Run(
      {"waterline", Path("cube.obj"), "--cutter", "cyl:4", "--z", "2,5", "-o", Path("loops.txt")});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("levels 2\nloops 2\nouter_loops 2\n"));
  EXPECT_THAT(Text("loops.txt"), StartsWith("2 "));
}

/// A plate on a leg: its overhang needs supports.
TEST_F(Program, PlansSupportsOfAModelAlone) {
  Put("table.obj",
      "v 8 8 0\nv 12 8 0\nv 12 12 0\nv 8 12 0\nv 8 8 8\nv 12 8 8\nv 12 12 8\nv 8 12 8\n"
      "v 0 0 8\nv 20 0 8\nv 20 20 8\nv 0 20 8\nv 0 0 10\nv 20 0 10\nv 20 20 10\nv 0 20 10\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"
      "f 12 11 10 9\nf 13 14 15 16\nf 9 10 14 13\nf 10 11 15 14\nf 11 12 16 15\nf 12 9 13 16\n");
  const Outcome outcome = Run(
      {"support-lab", Path("table.obj"), "--style", "grid", "-o", Path("lab"), "--every", "20"});
  ASSERT_EQ(outcome.code, ExitCode::kOk) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nnot_carried_mm2 "));
  for (const char* file : {"lab/lab.gcode", "lab/front.png", "lab/right.png", "lab/layer0000.png"})
    EXPECT_GT(Text(file).size(), 100u) << file;
}

}  // namespace
}  // namespace slicefarm::lab::lab_program_test
