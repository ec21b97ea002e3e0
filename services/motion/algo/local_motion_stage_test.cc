#include "services/motion/algo/local_motion_stage.h"

#include <gtest/gtest.h>

#include <utility>

#include "common/base/error.h"
#include "common/stage/motion_job.h"

namespace slicefarm::motion::local_motion_stage_test {
namespace {

std::vector<OrderedLayer> Layers(int count) {
  std::vector<OrderedLayer> layers(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    OrderedLayer& layer = layers[static_cast<size_t>(i)];
    layer.frame = {i, (i + 1) * 200'000, 200'000};
    Path path;
    path.points = {{0, 0}, {FromMm(10), 0}};
    path.widths_nm = {450'000};
    layer.blocks = {{0, i, 200'000, {path}}};
    layer.visits = {{0, 0, 0, {}}};
  }
  return layers;
}

TEST(LocalMotion, OneProgramALayer) {
  const auto programs = MakeLocalMotion()->Program({}, Layers(3), {});
  ASSERT_TRUE(programs.ok());
  ASSERT_EQ(programs->size(), 3);
  EXPECT_EQ((*programs)[2].frame.index, 2);
}

TEST(LocalMotion, AProgramForEachPassOfALayer) {
  std::vector<OrderedLayer> layers = Layers(3);
  layers[0].visits.push_back({0, 1, 1, {FromMm(50), 0}});
  layers[1].visits.clear();
  const auto programs = MakeLocalMotion()->Program({}, layers, {});
  ASSERT_TRUE(programs.ok());
  std::vector<std::pair<int32_t, int32_t>> made;
  for (const LayerProgram& program : *programs)
    made.emplace_back(program.frame.index, program.pass);
  EXPECT_EQ(made, (std::vector<std::pair<int32_t, int32_t>>{{0, 0}, {0, 1}, {1, 0}, {2, 0}}));
}

TEST(LocalMotion, TemplatesAreToldOfTheJob) {
  MotionOptions options;
  options.layer_gcode = "; layer {layer_num + 1} of {total_layer_count}";
  JobFacts facts;
  facts.layer_count = 40;
  const auto programs = MakeLocalMotion()->Program({}, Layers(2), MotionJob{options, facts});
  ASSERT_TRUE(programs.ok()) << programs.status();
  EXPECT_NE((*programs)[1].gcode.find("; layer 2 of 40\n"), std::string::npos);
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
  options.tool().filament_diameter_mm = 0;
  EXPECT_EQ(DetailOf(stage->Program({}, Layers(1), MotionJob{options, {}}).status()).reason,
            Reason::kSettingOutOfRange);
  EXPECT_EQ(DetailOf(stage->Envelope({}, {}, options).status()).reason, Reason::kSettingOutOfRange);
  std::vector<OrderedLayer> layers = Layers(2);
  layers[1].blocks[0].paths[0].points.clear();
  EXPECT_EQ(DetailOf(stage->Program({}, layers, {}).status()).reason, Reason::kRequestMalformed);
}

TEST(LocalMotion, StopsWhenCancelled) {
  int polls = 0;
  StageCall call;
  call.cancel = CancelToken([&polls] { return ++polls > 1; });
  EXPECT_EQ(MakeLocalMotion()->Program(call, Layers(9), {}).status().code(),
            absl::StatusCode::kCancelled);
  EXPECT_EQ(polls, 2);
  EXPECT_EQ(MakeLocalMotion()->Envelope(call, {}, {}).status().code(),
            absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::motion::local_motion_stage_test
