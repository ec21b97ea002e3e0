#include "services/infill/algo/patterns/rectilinear.h"

#include <gtest/gtest.h>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::rectilinear_test {
namespace {

TEST(Rectilinear, TurnsFromLayerToLayerUnlessAligned) {
  for (const int32_t layer : {0, 1}) {
    const PatternContext context{.layer = layer, .pitch_nm = 2e6};
    const auto turning = Rectilinear(SampleBox(), context),
               aligned = AlignedRectilinear(SampleBox(), context);
    EXPECT_EQ((*aligned)[0].points[0].y, (*aligned)[0].points[1].y);
    EXPECT_EQ((*turning)[0].points[0].y == (*turning)[0].points[1].y, layer == 0);
    EXPECT_NEAR(LengthOf(*turning), 48e6 * 24, 1);
  }
}

}  // namespace
}  // namespace slicefarm::infill::rectilinear_test
