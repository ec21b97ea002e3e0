#include "services/motion/algo/toolpath/reversal.h"

#include <gtest/gtest.h>

#include <string>

#include "common/geometry/text_format_test.h"
#include "common/model/paths_test.h"

namespace slicefarm::motion::reversal_test {
namespace {

Path Wall(Feature feature) {
  Path path = MakePathOrDie("(0 0, 10 0, 10 10, 0 10)");
  path.closed = true;
  path.feature = feature;
  path.widths_nm = {400'000};
  return path;
}

struct Case {
  std::string name;
  OverhangReversal reversal;
  int32_t layer;
  Feature feature;
  std::string below;
  bool reversed;
};
class Reversal : public testing::TestWithParam<Case> {};

TEST_P(Reversal, DependsOnLayerWallAndOverhang) {
  const LayerBelow below(MakePolygonsOrDie(GetParam().below));
  EXPECT_EQ(IsReversed(Wall(GetParam().feature), GetParam().reversal, GetParam().layer, &below),
            GetParam().reversed);
}

constexpr const char* kWide = "(-2 -2, 12 -2, 12 12, -2 12)";
// The right wall overhangs by 0.3 mm: its centre is 0.1 mm outside.
constexpr const char* kNarrow = "(-2 -2, 9.9 -2, 9.9 12, -2 12)";
constexpr OverhangReversal kOff = {}, kAll = {.on = true},
                           kInner = {.on = true, .inner_only = true};
constexpr OverhangReversal kBeyond = {.on = true, .threshold_mm = 0.2};
constexpr OverhangReversal kFarBeyond = {.on = true, .threshold_mm = 0.35};

INSTANTIATE_TEST_SUITE_P(
    Walls, Reversal,
    testing::Values(Case{"Off", kOff, 1, Feature::kPerimeter, kNarrow, false},
                    Case{"EvenLayer", kAll, 2, Feature::kPerimeter, kNarrow, false},
                    Case{"OddLayer", kAll, 1, Feature::kPerimeter, kWide, true},
                    Case{"Infill", kAll, 1, Feature::kInternalInfill, kNarrow, false},
                    Case{"OuterKept", kInner, 1, Feature::kExternalPerimeter, kNarrow, false},
                    Case{"Inner", kInner, 1, Feature::kPerimeter, kNarrow, true},
                    Case{"Carried", kBeyond, 1, Feature::kExternalPerimeter, kWide, false},
                    Case{"Overhang", kBeyond, 1, Feature::kExternalPerimeter, kNarrow, true},
                    Case{"TooSmall", kFarBeyond, 1, Feature::kExternalPerimeter, kNarrow, false}),
    [](const auto& info) { return info.param.name; });

TEST(Reversal, KeepsTheStart) {
  Path path = Wall(Feature::kPerimeter);
  path.widths_nm = {1, 2, 3, 4};
  const Path reversed = Reversed(path);
  EXPECT_EQ(reversed.points.front(), path.points.front());
  EXPECT_EQ(reversed.points[1], path.points[3]);
  EXPECT_EQ(reversed.widths_nm, (std::vector<Coord>{1, 4, 3, 2}));
  EXPECT_EQ(Reversed(reversed), path);
}

}  // namespace
}  // namespace slicefarm::motion::reversal_test
