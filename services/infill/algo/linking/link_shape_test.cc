#include "services/infill/algo/linking/link_shape.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"

namespace slicefarm::infill::link_shape_test {
namespace {

/// Two upright lines, linked at the lower edge.
std::vector<LinkShape> Shapes(const MultiPolygon& region, double cut_nm, const char* left,
                              const char* right) {
  const std::vector<Piece> pieces = {{MakeLineOrDie(left), {0, 0}, {0, 2}},
                                     {MakeLineOrDie(right), {0, 0}, {0, 2}}};
  const EdgeEnds ends(region, pieces);
  Links links(4, false);
  links[0] = true;
  return ShapeLinks(ends, links, EdgeIndex(region, 1'000'000), cut_nm);
}

MultiPolygon Square() { return MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)"); }

TEST(LinkShape, RunsAlongTheEdge) {
  const auto shapes = Shapes(Square(), 0, "(2 0, 2 10)", "(4 0, 4 10)");
  ASSERT_EQ(shapes.size(), 1u);
  EXPECT_EQ(shapes[0].way, MakeLineOrDie("(2 0, 4 0)"));
  EXPECT_NEAR(shapes[0].Net(1), 2e6, 1);
  EXPECT_NEAR(shapes[0].Net(0.5), 1e6, 1);
}

TEST(LinkShape, CutsItsCornersOff) {
  const auto shapes = Shapes(Square(), 0.5e6, "(2 0, 2 10)", "(4 0, 4 10)");
  EXPECT_EQ(shapes[0].way, MakeLineOrDie("(2 0.5, 2.5 0, 3.5 0, 4 0.5)"));
  EXPECT_NEAR(shapes[0].Net(1), 2 * 0.70711e6 + 1e6 - 1e6, 10);
}

TEST(LinkShape, AShortLinkIsAllCorner) {
  const auto shapes = Shapes(Square(), 3e6, "(2 0, 2 10)", "(4 0, 4 10)");
  EXPECT_EQ(shapes[0].way, MakeLineOrDie("(2 1, 3 0, 4 1)"));
}

TEST(LinkShape, ShortPiecesKeepSomethingOfThemselves) {
  const MultiPolygon strip = MakePolygonsOrDie("(0 0, 10 0, 10 1, 0 1)");
  const auto shapes = Shapes(strip, 3e6, "(2 0, 2 1)", "(6 0, 6 1)");
  EXPECT_NEAR(shapes[0].from_cut_nm, 0.4e6, 1);
  EXPECT_NEAR(shapes[0].to_cut_nm, 0.4e6, 1);
}

// A hole lies in the left corner, the right one is free.
TEST(LinkShape, CutsNothingAcrossAHole) {
  const MultiPolygon region = MakePolygonsOrDie(
      "(0 0, 10 0, 10 10, 0 10) (2.3 0.3, 2.3 0.6, 2.6 0.6, 2.6 0.3)");
  const auto shapes = Shapes(region, 1e6, "(2 0, 2 10)", "(6 0, 6 10)");
  EXPECT_EQ(shapes[0].from_cut_nm, 0);
  EXPECT_EQ(shapes[0].way, MakeLineOrDie("(2 0, 5 0, 6 1)"));
}

}  // namespace
}  // namespace slicefarm::infill::link_shape_test
