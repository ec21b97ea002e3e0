#include "services/slicing/algo/section/layer_heights.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/base/error.h"

namespace slicefarm::slicing::layer_heights_test {
namespace {

LayerHeights Heights(Coord first, Coord layer) { return {first, layer, {}}; }

TEST(LayerPlanes, CutsInTheMiddle) {
  const auto planes = LayerPlanes(990'000, Heights(300'000, 200'000));
  ASSERT_TRUE(planes.ok());
  ASSERT_EQ(planes->size(), 4u);
  const std::vector<Coord> z = {150'000, 400'000, 600'000, 800'000},
                           top = {300'000, 500'000, 700'000, 900'000};
  for (int32_t k = 0; k < 4; ++k) {
    EXPECT_EQ((*planes)[k].frame, (LayerFrame{k, top[k], k == 0 ? 300'000 : 200'000}));
    EXPECT_EQ((*planes)[k].z_nm, z[k]);
  }
}

struct Case {
  Coord top, first, layer;
  size_t want;
};

TEST(LayerPlanes, TheLastMiddleLiesNoHigherThanTheTop) {
  const std::vector<Case> cases = {{48'000'000, 200'000, 200'000, 240},
                                   {1'000'000, 200'000, 200'000, 5},
                                   {1'099'000, 200'000, 200'000, 5},
                                   {1'100'000, 200'000, 200'000, 6},
                                   {1'101'000, 200'000, 200'000, 6},
                                   {13'500'000, 200'000, 200'000, 68},
                                   {13'499'999, 200'000, 200'000, 68},  // a value rounded as float
                                   {13'499'000, 200'000, 200'000, 67},
                                   {100'000, 200'000, 200'000, 1},
                                   {101'000, 200'000, 200'000, 1},
                                   {1'000, 1'000, 1'000, 1},
                                   {10'000, 3'000, 3'000, 3}};
  for (const Case& c : cases) {
    const auto planes = LayerPlanes(c.top, Heights(c.first, c.layer));
    ASSERT_TRUE(planes.ok());
    EXPECT_EQ(planes->size(), c.want) << c.top;
    EXPECT_LT(planes->back().z_nm, c.top) << "what lies at the top's own height is not cut";
    EXPECT_GE(planes->back().z_nm + c.layer, c.top);
  }
}

TEST(LayerPlanes, RefusesWhatCannotBe) {
  const auto reason = [](Coord top, Coord first, Coord layer) {
    return DetailOf(LayerPlanes(top, Heights(first, layer)).status()).reason;
  };
  EXPECT_EQ(reason(1'000, 0, 200), Reason::kSettingOutOfRange);
  EXPECT_EQ(reason(1'000, 200, -1), Reason::kSettingOutOfRange);
  EXPECT_EQ(reason(99'000, 200'000, 200'000), Reason::kNothingToPrint);
  EXPECT_EQ(reason(0, 200'000, 200'000), Reason::kNothingToPrint);
  EXPECT_EQ(reason(2'000'000'000, 200, 200), Reason::kMeshTooLarge);
}

TEST(LayerPlanes, RangesHaveHeightsOfTheirOwn) {
  LayerHeights heights = Heights(200'000, 200'000);
  heights.ranges = {{400'000, 1'000'000, 100'000}, {800'000, 2'000'000, 300'000}};
  const auto planes = LayerPlanes(1'900'000, heights);
  ASSERT_TRUE(planes.ok());
  std::vector<Coord> got;
  for (const LayerPlane& plane : *planes) got.push_back(plane.frame.height_nm / 1'000);
  // The first matching range counts; the last layer's middle is below the top.
  EXPECT_EQ(got, (std::vector<Coord>{200, 200, 100, 100, 100, 100, 100, 100, 300, 300, 300}));
  EXPECT_EQ(planes->back().frame.print_z_nm, 1'900'000);
}

struct TopCase {
  Coord top, first, layer;
  HeightLimits range;
  std::vector<Coord> last_heights;  ///< heights of the last layers
  Coord end;
};

TEST(MeetTop, ChangesTheLastFiveLayersEvenly) {
  const HeightLimits wide = {70'000, 300'000};
  for (const TopCase& c :
       {TopCase{2'050'000,
                200'000,
                200'000,
                wide,
                {200'000, 210'000, 210'000, 210'000, 210'000, 210'000},
                2'050'000},
        {1'950'000,
         200'000,
         200'000,
         wide,
         {200'000, 190'000, 190'000, 190'000, 190'000, 190'000},
         1'950'000},
        {2'000'000, 200'000, 200'000, wide, {200'000, 200'000}, 2'000'000},
        {450'000, 200'000, 200'000, wide, {200'000, 250'000}, 450'000},
        // The heights reach their limit before the top is met.
        {490'000, 200'000, 200'000, {70'000, 250'000}, {200'000, 250'000}, 450'000}}) {
    auto planes = *LayerPlanes(c.top, Heights(c.first, c.layer));
    MeetTop(c.top, c.range, planes);
    EXPECT_EQ(planes.back().frame.print_z_nm, c.end) << c.top;
    Coord bottom = 0;
    for (size_t i = 0; i < planes.size(); ++i) {
      const LayerFrame& frame = planes[i].frame;
      EXPECT_EQ(frame.print_z_nm, bottom + frame.height_nm);
      EXPECT_GT(planes[i].z_nm, bottom);
      EXPECT_LT(planes[i].z_nm, frame.print_z_nm);
      bottom = frame.print_z_nm;
      const size_t left = planes.size() - i;
      if (left > c.last_heights.size()) continue;
      EXPECT_EQ(frame.height_nm, c.last_heights[c.last_heights.size() - left]) << c.top << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace slicefarm::slicing::layer_heights_test
