#include "services/ordering/algo/local_ordering_stage.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/stage/ordering_job.h"

namespace slicefarm::ordering::local_ordering_stage_test {
namespace {

std::vector<FilledLayer> Layers(int count) {
  std::vector<FilledLayer> layers(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) layers[static_cast<size_t>(i)].frame.index = i;
  return layers;
}

TEST(LocalOrdering, OneResultALayer) {
  const std::vector<LayerPlan> plans(3);
  const auto ordered = MakeLocalOrdering()->Order({}, Layers(3), plans, {});
  ASSERT_TRUE(ordered.ok());
  ASSERT_EQ(ordered->size(), 3);
  for (int i = 0; i < 3; ++i) EXPECT_EQ((*ordered)[static_cast<size_t>(i)].frame.index, i);
}

TEST(LocalOrdering, APlanForEachLayer) {
  const std::vector<LayerPlan> plans(2);
  const auto ordered = MakeLocalOrdering()->Order({}, Layers(3), plans, {});
  EXPECT_EQ(DetailOf(ordered.status()).reason, Reason::kRequestMalformed);
}

TEST(LocalOrdering, StopsWhenCancelled) {
  int polls = 0;
  StageCall call;
  call.cancel = CancelToken([&polls] { return ++polls > 2; });
  const std::vector<LayerPlan> plans(5);
  const auto ordered = MakeLocalOrdering()->Order(call, Layers(5), plans, {});
  EXPECT_EQ(ordered.status().code(), absl::StatusCode::kCancelled);
  EXPECT_EQ(polls, 3);
}

}  // namespace
}  // namespace slicefarm::ordering::local_ordering_stage_test
