#include "services/slicing/algo/mesh_io/threemf/bed_box.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::slicing::threemf::bed_box_test {
namespace {

using testing::ElementsAre;

TEST(BedBoxOf, ReadsBothFamiliesLists) {
  for (const char* area :
       {"-10x5,240x5,240x215,-10x215", R"(["-10x5", "240x5", "240x215", "-10x215"])"}) {
    const auto box = BedBoxOf({{"other", "1"}, {"bed_shape", area}}, "bed_shape");
    ASSERT_TRUE(box) << area;
    EXPECT_THAT(box->min, ElementsAre(-10, 5)) << area;
    EXPECT_THAT(box->size, ElementsAre(250, 210)) << area;
  }
}

TEST(BedBoxOf, IsNothingWithoutABed) {
  EXPECT_FALSE(BedBoxOf({}, "bed_shape"));
  for (const char* area : {"", "[]", "0x0,0x0", "0x0,10x0", "nanx0,1x1", "1e9x0,0x1e9"})
    EXPECT_FALSE(BedBoxOf({{"bed_shape", area}}, "bed_shape")) << area;
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::bed_box_test
