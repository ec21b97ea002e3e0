#include "services/beading/algo/arachne/facing_sides.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <string_view>

#include "common/geometry/text_format_test.h"

namespace slicefarm::beading::facing_sides_test {
namespace {

struct FacingCase {
  std::string name;
  std::string text;
  bool face = false;
};
class Facing : public testing::TestWithParam<FacingCase> {};

TEST_P(Facing, SidesWithinTwoMillimetres) {
  const MultiPolygon island = MakePolygonsOrDie(GetParam().text);
  EXPECT_EQ(SeesFacingSides(island[0], FromMm(2), 170 * std::numbers::pi / 180, 40),
            GetParam().face);
}

INSTANTIATE_TEST_SUITE_P(
    FacingSides, Facing,
    testing::Values(FacingCase{"Strip", "(0 0, 20 0, 20 1.9, 0 1.9)", true},
                    FacingCase{"WiderStrip", "(0 0, 20 0, 20 2.1, 0 2.1)", false},
                    FacingCase{"Frame", "(0 0, 20 0, 20 20, 0 20) (1 1, 1 19, 19 19, 19 1)", true},
                    FacingCase{"WideFrame", "(0 0, 20 0, 20 20, 0 20) (5 5, 5 15, 15 15, 15 5)",
                               false},
                    // The sides of a gap face each other across air.
                    FacingCase{"Gap", "(0 0, 20 0, 20 20, 11 20, 11 5, 10 5, 10 20, 0 20)", false},
                    FacingCase{"TipOf22Degrees", "(0 0, 20 0, 0 8)", false}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::beading::facing_sides_test
