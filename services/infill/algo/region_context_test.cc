#include "services/infill/algo/region_context.h"

#include <gtest/gtest.h>

#include <numbers>
#include <optional>

#include "common/model/options/infill_options.h"

namespace slicefarm::infill::region_context_test {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

class OfRegion : public testing::Test {
 protected:
  RegionContext At(int32_t layer, bool on_bed = false) {
    view_.layer = layer;
    view_.on_bed = on_bed;
    view_.height_nm = 200'000;
    return {view_, 3, options_};
  }

  const ObjectLayers stacks_{{}};
  const MultiPolygon nothing_ = {};
  SectionView view_{.stack = 0, .stacks = stacks_, .above_supports = nothing_};
  InfillOptions options_;
};

TEST_F(OfRegion, LinesOnTheBedHaveTheirOwnWidth) {
  options_.first_layer_width_nm = 600'000;
  EXPECT_EQ(At(0, true).Width(400'000), 600'000);
  EXPECT_EQ(At(1).Width(400'000), 400'000);
}

TEST_F(OfRegion, SolidLinesTurnFromLayerToLayer) {
  options_.solid_angle_rad = 0.1;
  EXPECT_DOUBLE_EQ(At(2).SolidAngle(FillPattern::kMonotonic), 0.1);
  EXPECT_DOUBLE_EQ(At(3).SolidAngle(FillPattern::kMonotonic), 0.1 + kRightAngle);
  EXPECT_DOUBLE_EQ(At(3).SolidAngle(FillPattern::kAlignedRectilinear), 0.1);
  options_.turn_rad = 0.2;
  EXPECT_DOUBLE_EQ(At(2).SolidAngle(FillPattern::kMonotonic), 0.1 + 0.2);
}

TEST_F(OfRegion, OnlyInterfaceShellsLookAtTheRegionAlone) {
  EXPECT_EQ(At(1).row, std::nullopt);
  options_.interface_shells = true;
  EXPECT_EQ(At(1).row, 3);
}

TEST_F(OfRegion, SpiralsTurnAroundTheMiddleOfTheirSurfaceIfAskedFor) {
  const auto center = [&] {
    return At(1).FillOf(Feature::kTopSolidInfill, FillPattern::kArchimedean, 0, 450'000, 0).center;
  };
  EXPECT_EQ(center(), Point{});
  options_.surfaces.center = SurfaceCenter::kSurface;
  EXPECT_EQ(center(), std::nullopt);
}

}  // namespace
}  // namespace slicefarm::infill::region_context_test
