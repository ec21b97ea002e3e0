#include "services/motion/algo/local_motion_stage.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::motion {
namespace {

std::vector<OrderedLayer> Layers(int count) {
  std::vector<OrderedLayer> layers(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    OrderedLayer& layer = layers[static_cast<size_t>(i)];
    layer.frame = {i, (i + 1) * 200'000, 200'000};
    Path path;
    path.points = {{0, 0}, {FromMm(10), 0}};
    path.widths_nm = {450'000};
    layer.paths = {path};
  }
  return layers;
}

TEST(LocalMotion, OneProgramALayer) {
  const auto programs = MakeLocalMotion()->Program({}, Layers(3), {});
  ASSERT_TRUE(programs.ok());
  ASSERT_EQ(programs->size(), 3);
  EXPECT_EQ((*programs)[2].frame.index, 2);
}

TEST(LocalMotion, LayersDoNotDependOnTheirNeighbours) {
  const auto all = MakeLocalMotion()->Program({}, Layers(5), {});
  std::vector<OrderedLayer> layers = Layers(5);
  const auto one = MakeLocalMotion()->Program({}, {layers[3]}, {});
  ASSERT_TRUE(all.ok() && one.ok());
  EXPECT_EQ((*all)[3], (*one)[0]);
}

TEST(LocalMotion, ChecksItsInput) {
  const auto stage = MakeLocalMotion();
  MotionOptions options;
  options.filament_diameter_mm = 0;
  EXPECT_EQ(DetailOf(stage->Program({}, Layers(1), options).status()).reason,
            Reason::kSettingOutOfRange);
  EXPECT_EQ(DetailOf(stage->Frame({}, {}, options).status()).reason, Reason::kSettingOutOfRange);
  std::vector<OrderedLayer> layers = Layers(2);
  layers[1].paths[0].points.clear();
  EXPECT_EQ(DetailOf(stage->Program({}, layers, {}).status()).reason, Reason::kRequestMalformed);
}

TEST(LocalMotion, StopsWhenCancelled) {
  int polls = 0;
  StageCall call;
  call.cancel = CancelToken([&polls] { return ++polls > 1; });
  EXPECT_EQ(MakeLocalMotion()->Program(call, Layers(9), {}).status().code(),
            absl::StatusCode::kCancelled);
  EXPECT_EQ(polls, 2);
  EXPECT_EQ(MakeLocalMotion()->Frame(call, {}, {}).status().code(), absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::motion
