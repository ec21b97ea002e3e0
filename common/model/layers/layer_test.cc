#include "common/model/layers/layer.h"

#include <gtest/gtest.h>

namespace slicefarm::layer_test {
namespace {

TEST(LayerRange, GrowsWithinTheJob) {
  EXPECT_EQ((LayerRange{4, 8}.Grown(5, 10)), (LayerRange{0, 10}));
  EXPECT_EQ((LayerRange{4, 8}.Grown(1, 10)), (LayerRange{3, 9}));
  EXPECT_TRUE((LayerRange{4, 8}.Contains(4)));
  EXPECT_FALSE((LayerRange{4, 8}.Contains(8)));
}

TEST(ProgramStats, AddsUp) {
  ProgramStats a, b;
  a.features[0] = {1, 2, 3, 4};
  a.travel_time_s = 5;
  a.bounds = {{0, 0}, {1, 1}};
  b.features[0] = {10, 20, 30, 40};
  b.features[3] = {1, 1, 1, 1};
  a.Add(b);
  EXPECT_EQ(a.TimeS(), 17);
  EXPECT_EQ(a.ExtrudedMm(), 23);
  EXPECT_EQ(a.FilamentMm(), 34);
  EXPECT_EQ(a.VolumeMm3(), 45);
  EXPECT_EQ(a.bounds, (Box{{0, 0}, {1, 1}}));
}

}  // namespace
}  // namespace slicefarm::layer_test
