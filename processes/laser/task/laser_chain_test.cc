#include "processes/laser/task/laser_chain.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/base/error.h"
#include "common/stage/exposure_job.h"

namespace slicefarm::laser_chain_test {
namespace {

struct Exposure : ExposureStage {
  absl::StatusOr<std::vector<ExposedProgram>> Expose(
      const StageCall&, const Neighbourhood& hood, const Shared<ExposureJob>& job) const override {
    if (fails) return MakeError(absl::StatusCode::kInternal, Reason::kInternal, "exposure");
    copy_count = job->copies.size();
    std::vector<ExposedProgram> programs(static_cast<size_t>(hood.range.size()));
    for (ExposedProgram& program : programs) program.frame.index = hood.range.first;
    return programs;
  }
  absl::StatusOr<ExposureEnvelope> Envelope(const StageCall&, const ExposureSummary&,
                                            const ExposureSettings&) const override {
    return ExposureEnvelope{};
  }
  bool fails = false;
  mutable size_t copy_count = 0;
};

class LaserChainTest : public testing::Test {
 protected:
  LaserChainTest() {
    settings_.regions[0].downskin_layers = 2;
    for (int32_t i = 0; i < 10; ++i) {
      SlicedLayer& layer = layers_.emplace_back();
      layer.frame.index = i;
      ObjectSection& section = layer.sections.emplace_back();
      section.layer = i;
      section.layer_count = 10;
    }
  }

  absl::StatusOr<LaserResult> Run(LayerRange range, LayerRange sent) const {
    const auto layers = std::span(layers_).subspan(static_cast<size_t>(sent.first),
                                                   static_cast<size_t>(sent.size()));
    return LaserChain(exposure_).Run({}, {range, layers, ExposureJob{settings_, copies_}});
  }

  Exposure exposure_;
  ExposureSettings settings_;
  std::vector<SlicedLayer> layers_;
  std::vector<Copy> copies_ = std::vector<Copy>(3);
};

TEST_F(LaserChainTest, GivesTheStageItsRangeAndCopies) {
  const auto result = Run({4, 6}, {2, 8});
  ASSERT_TRUE(result.ok()) << result.status();
  EXPECT_EQ(result->programs.size(), 2u);
  EXPECT_EQ(result->programs[0].frame.index, 4);
  EXPECT_EQ(exposure_.copy_count, 3u);
}

TEST_F(LaserChainTest, RefusesARangeWithoutItsHalo) {
  EXPECT_EQ(DetailOf(Run({4, 6}, {3, 8}).status()).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(Run({4, 6}, {2, 7}).status()).reason, Reason::kRequestMalformed);
}

TEST_F(LaserChainTest, HandsErrorsOn) {
  exposure_.fails = true;
  EXPECT_EQ(Run({4, 6}, {2, 8}).status().message(), "exposure");
}

}  // namespace
}  // namespace slicefarm::laser_chain_test
