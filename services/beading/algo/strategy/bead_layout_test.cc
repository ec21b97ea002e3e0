#include "services/beading/algo/strategy/bead_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::beading::bead_layout_test {
namespace {

struct LayoutCase {
  std::string name;
  Coord thickness_nm;
  int count;
  std::vector<Coord> half_widths_nm;
  Beading beading;
};

class Layout : public testing::TestWithParam<LayoutCase> {};

TEST_P(Layout, IsThis) {
  const LayoutCase& c = GetParam();
  const Beading beading = LayOut(c.thickness_nm, c.count, c.half_widths_nm);
  EXPECT_EQ(beading.thickness_nm, c.thickness_nm);
  EXPECT_EQ(beading.widths_nm, c.beading.widths_nm);
  EXPECT_EQ(beading.locations_nm, c.beading.locations_nm);
  EXPECT_EQ(beading.left_over_nm, c.beading.left_over_nm);
}

INSTANTIATE_TEST_SUITE_P(
    Bead, Layout,
    testing::Values(  // name, thickness, count, half; thickness, widths, locations, left-over
        LayoutCase{"Nothing", 1000, 0, {}, {1000, {}, {}, 1000}},
        LayoutCase{"LoneBeadInTheMiddle", 1000, 1, {400}, {1000, {400}, {500}, 600}},
        LayoutCase{"WiderThanItsPlace", 300, 1, {340}, {300, {340}, {150}, -40}},
        LayoutCase{"TwoFillIt", 1000, 2, {500}, {1000, {500, 500}, {250, 750}, 0}},
        LayoutCase{"OddThicknessLeavesOne", 1001, 2, {500}, {1001, {500, 500}, {250, 751}, 1}},
        LayoutCase{"OddWidthIsMirrored", 1000, 2, {333}, {1000, {333, 333}, {166, 834}, 334}},
        LayoutCase{"Three", 1100, 3, {400, 300}, {1100, {400, 300, 400}, {200, 550, 900}, 0}},
        LayoutCase{"GapAroundTheMiddle",
                   2000,
                   3,
                   {400, 300},
                   {2000, {400, 300, 400}, {200, 1000, 1800}, 900}},
        LayoutCase{"GapBetweenHalves",
                   5000,
                   4,
                   {400, 300},
                   {5000, {400, 300, 300, 400}, {200, 550, 4450, 4800}, 3600}},
        LayoutCase{"Five",
                   2000,
                   5,
                   {300, 400, 600},
                   {2000, {300, 400, 600, 400, 300}, {150, 500, 1000, 1500, 1850}, 0}}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::beading::bead_layout_test
