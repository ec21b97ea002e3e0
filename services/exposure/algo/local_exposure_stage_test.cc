#include "services/exposure/algo/local_exposure_stage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"
#include "common/stage/exposure_job.h"

namespace slicefarm::exposure::local_exposure_stage_test {
namespace {

using testing::HasSubstr;

class LocalExposureTest : public testing::Test {
 protected:
  LocalExposureTest() {
    for (int32_t i = 0; i < 12; ++i) {
      SlicedLayer& layer = layers_.emplace_back();
      layer.frame = {i, FromMm(0.1 * (i + 1)), FromMm(0.1)};
      ObjectSection& section = layer.sections.emplace_back();
      section.layer = i;
      section.layer_count = 12;
      section.height_nm = FromMm(0.1);
      // The step in the outline creates skins.
      section.regions.push_back(
          {.outlines = MakePolygonsOrDie(i < 6 ? "(0 0, 9 0, 9 9, 0 9)" : "(2 2, 9 2, 9 9, 2 9)")});
    }
    settings_.regions[0].hatch_distance_nm = FromMm(0.3);
    settings_.regions[0].upskin_layers = 2;
  }

  absl::StatusOr<std::vector<ExposedProgram>> Expose(LayerRange range, LayerRange sent,
                                                     const StageCall& call = {}) const {
    return stage_->Expose(call,
                          {range, std::span(layers_).subspan(static_cast<size_t>(sent.first),
                                                             static_cast<size_t>(sent.size()))},
                          ExposureJob{settings_, copies_});
  }

  const std::unique_ptr<ExposureStage> stage_ = MakeLocalExposure();
  std::vector<SlicedLayer> layers_;
  std::vector<Copy> copies_ = {{0, {0, 0}, 0}, {0, {FromMm(20), 0}, 0}};
  ExposureSettings settings_;
};

TEST_F(LocalExposureTest, RangesGiveWhatTheWholeGives) {
  for (const OutputFormat format :
       {OutputFormat::kCliAscii, OutputFormat::kCliBinary, OutputFormat::kGrbl,
        OutputFormat::kMarlin, OutputFormat::kSvg, OutputFormat::kDxf}) {
    settings_.output.format = format;
    const auto whole = Expose({0, 12}, {0, 12});
    ASSERT_TRUE(whole.ok()) << whole.status();
    ASSERT_EQ(whole->size(), 12u);
    for (int32_t i = 0; i < 12; ++i) {
      const auto one = Expose({i, i + 1}, {std::max(0, i - 2), std::min(12, i + 3)});
      ASSERT_TRUE(one.ok()) << one.status();
      EXPECT_EQ(one->front(), (*whole)[static_cast<size_t>(i)]) << i;
    }
  }
}

TEST_F(LocalExposureTest, ReportsWhatItWrites) {
  const auto programs = Expose({0, 12}, {0, 12});
  ASSERT_TRUE(programs.ok()) << programs.status();
  ExposureReport sum;
  for (const ExposedProgram& program : *programs) sum.Add(program.report);
  EXPECT_NEAR(sum.area_mm2, 2 * 6 * (81 + 49), 1e-6);
  EXPECT_NEAR(sum.volume_mm3, 0.1 * sum.area_mm2, 1e-6);
  EXPECT_GT(sum.kinds[static_cast<size_t>(ExposureKind::kUpskin)].lines, 0);
  EXPECT_GT(sum.EnergyDensityJmm3(), 0);
  EXPECT_LE(sum.bounds.max.x, FromMm(29));
  EXPECT_GT(sum.bounds.max.x, FromMm(28.8));
}

TEST_F(LocalExposureTest, TheFrameNamesLayersAndObjects) {
  const auto frame =
      stage_->Envelope({}, {12, {{0, 0}, {9, 9}}, 0, FromMm(1.2), {"block"}}, settings_);
  ASSERT_TRUE(frame.ok()) << frame.status();
  EXPECT_THAT(frame->header, HasSubstr("$$LAYERS/"));
  EXPECT_THAT(frame->header, HasSubstr("12"));
  EXPECT_THAT(frame->header, HasSubstr("block"));
  EXPECT_THAT(frame->footer, HasSubstr("$$GEOMETRYEND"));
}

TEST_F(LocalExposureTest, RefusesRegionsWithoutSettings) {
  layers_[3].sections[0].regions[0].settings = 1;
  EXPECT_EQ(DetailOf(Expose({0, 12}, {0, 12}).status()).reason, Reason::kRequestMalformed);
}

TEST_F(LocalExposureTest, IsCancelled) {
  StageCall call;
  call.cancel = CancelToken([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(Expose({0, 12}, {0, 12}, call).status()));
}

}  // namespace
}  // namespace slicefarm::exposure::local_exposure_stage_test
