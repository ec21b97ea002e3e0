#include "services/infill/algo/lines/line_flow.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/quality/fill_plastic.h"

namespace slicefarm::infill::line_flow_test {
namespace {

constexpr Coord kHeight = 200'000;
constexpr Coord kWidth = 450'000;

Path PathAlong(std::string_view points, bool closed = false) {
  return {.closed = closed, .points = MakeLineOrDie(points), .widths_nm = {kWidth}};
}

double Share(const Path& thin, const Path& full) {
  return PlasticMm3(thin, kHeight) / PlasticMm3(full, kHeight);
}

TEST(ThinShortLines, EachLineGetsWhatItsLengthAsksFor) {
  const FlowTable table = *ParseFlowTable("0,0;1,0.5;10,1");
  const Path full = PathAlong("(0 0, 20 0, 20 1, 0 1)");
  Path path = full;
  ThinShortLines(table, kHeight, path);
  // The two lines keep their width. The link of 1 mm between them has half of its plastic.
  const Coord half = WidthFor(0.5, kWidth, kHeight, kHeight);
  EXPECT_EQ(path.points, MakeLineOrDie("(0 0, 20 0, 20 0, 20 1, 20 1, 0 1)"));
  EXPECT_EQ(path.widths_nm, (std::vector<Coord>{kWidth, kWidth, half, half, kWidth, kWidth}));
  EXPECT_NEAR(Share(path, full), 40.5 / 41, 1e-4);
}

TEST(ThinShortLines, LongLinesStayAsTheyAre) {
  const Path full = PathAlong("(0 0, 20 0, 20 10, 0 10)");
  Path path = full;
  ThinShortLines(*ParseFlowTable("0,0;10,1"), kHeight, path);
  EXPECT_EQ(path, full);
}

// A bend of 30 degrees or a step of the width does not end a line.
TEST(ThinShortLines, ALineGoesFromTurnToTurn) {
  const FlowTable table = *ParseFlowTable("0,0;10,0;10.1,1");
  Path bent = PathAlong("(0 0, 6 0, 11.196 3)");
  const Path full = bent;
  ThinShortLines(table, kHeight, bent);
  EXPECT_EQ(bent, full);
  Path steps{.points = MakeLineOrDie("(0 0, 6 0, 6 0, 12 0)"),
             .widths_nm = {kWidth, kWidth, kWidth / 2, kWidth / 2}};
  const Path before = steps;
  ThinShortLines(table, kHeight, steps);
  EXPECT_EQ(steps, before);
}

TEST(ThinShortLines, VaryingWidthsKeepTheirProportions) {
  const Path full{.points = MakeLineOrDie("(0 0, 1 0, 2 0)"),
                  .widths_nm = {kWidth, 600'000, kWidth}};
  Path path = full;
  ThinShortLines(*ParseFlowTable("0,0.7;5,0.7;6,1"), kHeight, path);
  EXPECT_EQ(path.points, full.points);
  EXPECT_NEAR(Share(path, full), 0.7, 1e-3);
}

TEST(ThinShortLines, AClosedPathBeginsInsideOfALine) {
  const Path full = PathAlong("(0 0, 8 0, 8 2, 0 2)", true);
  Path path = full;
  ThinShortLines(*ParseFlowTable("0,0.25;3,0.25;4,1"), kHeight, path);
  EXPECT_TRUE(path.closed);
  EXPECT_EQ(path.points, MakeLineOrDie("(4 0, 8 0, 8 0, 8 2, 8 2, 0 2, 0 2, 0 0, 0 0)"));
  EXPECT_NEAR(Share(path, full), (16 + 0.25 * 4) / 20, 1e-4);
  Path all = full;
  ThinShortLines(*ParseFlowTable("0,0.25;9,0.25;10,1"), kHeight, all);
  EXPECT_EQ(all.widths_nm.size(), 1u);
  EXPECT_NEAR(Share(all, full), 0.25, 1e-4);
}

TEST(ThinShortLines, NoPlasticIsTheThinnestBead) {
  Path path = PathAlong("(0 0, 1 0)");
  ThinShortLines(*ParseFlowTable("0,0;2,0;3,1"), kHeight, path);
  EXPECT_EQ(path.widths_nm, std::vector<Coord>{1});
}

}  // namespace
}  // namespace slicefarm::infill::line_flow_test
