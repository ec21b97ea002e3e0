#include "services/texture/algo/local_texture_stage.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::texture::local_texture_stage_test {
namespace {

/// Returns a bent strip.
SurfaceMesh Strip() {
  SurfaceMesh mesh;
  constexpr int kColumns = 12, kRows = 8;
  for (int j = 0; j <= kRows; ++j)
    for (int i = 0; i <= kColumns; ++i) mesh.points_mm.push_back({1.0 * i, 1.0 * j, 0.05 * i * i});
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const int a = j * (kColumns + 1) + i, b = a + kColumns + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

class LocalTextureTest : public testing::Test {
 protected:
  Shared<EngraveInput> Input(EngraveFormat format) const {
    const auto map = stage_->Map({}, SurfaceInput{Strip()});
    EXPECT_TRUE(map.ok()) << map.status();
    EngraveInput input;
    input.settings.format = format;
    input.settings.texture.texture = "bumps:pitch=2,height=0.3";
    input.settings.lines.spacing = "0.4";
    input.surface = *map;
    return input;
  }

  const std::unique_ptr<TextureStage> stage_ = MakeLocalTexture();
};

TEST_F(LocalTextureTest, RangesGiveTheSameLayersAsAllTogether) {
  for (const EngraveFormat format : {EngraveFormat::kCsv, EngraveFormat::kGcode}) {
    const auto input = Input(format);
    const auto layout = stage_->LayOut({}, input);
    ASSERT_TRUE(layout.ok()) << layout.status();
    ASSERT_EQ(layout->layer_count, 6);
    EXPECT_EQ(layout->footer.empty(), format == EngraveFormat::kCsv);
    const auto all = stage_->Engrave({}, input, {0, 6});
    ASSERT_TRUE(all.ok()) << all.status();
    for (int32_t i = 0; i < 6; ++i) {
      const auto one = stage_->Engrave({}, input, {i, i + 1});
      ASSERT_TRUE(one.ok()) << one.status();
      EXPECT_EQ(one->front(), (*all)[static_cast<size_t>(i)]) << i;
      EXPECT_FALSE(one->front().text.empty()) << i;
    }
  }
}

TEST_F(LocalTextureTest, AWholeFileIsOnePiece) {
  for (const EngraveFormat format :
       {EngraveFormat::kStl, EngraveFormat::kObj, EngraveFormat::kPng, EngraveFormat::kMapPng}) {
    const auto input = Input(format);
    const auto layout = stage_->LayOut({}, input);
    ASSERT_TRUE(layout.ok()) << layout.status();
    EXPECT_EQ(layout->layer_count, 6);
    EXPECT_EQ(layout->header + layout->footer, "");
    const auto pieces = stage_->Engrave({}, input, {0, 1});
    ASSERT_TRUE(pieces.ok()) << pieces.status();
    ASSERT_EQ(pieces->size(), 1u);
    EXPECT_GT(pieces->front().text.size(), 1000u);
    EXPECT_TRUE(stage_->Engrave({}, input, {0, 0})->empty());
    EXPECT_EQ(DetailOf(stage_->Engrave({}, input, {0, 2}).status()).reason,
              Reason::kRequestMalformed);
  }
}

TEST_F(LocalTextureTest, NamesWhatCannotBe) {
  const auto input = Input(EngraveFormat::kCsv);
  EXPECT_EQ(DetailOf(stage_->Engrave({}, input, {0, 7}).status()).reason,
            Reason::kRequestMalformed);
  EngraveInput wrong = *input;
  wrong.settings.texture.anchor = "1,2";
  EXPECT_EQ(DetailOf(stage_->LayOut({}, wrong).status()).metadata["setting"], "anchor");
  wrong = *input;
  wrong.image = "no PNG";
  EXPECT_FALSE(stage_->LayOut({}, wrong).ok());
}

TEST_F(LocalTextureTest, AMapThatIsCancelledIsMadeByTheNextCall) {
  const Shared<SurfaceInput> surface(SurfaceInput{Strip()});
  StageCall cancelled;
  cancelled.cancel = CancelToken([] { return true; });
  EXPECT_FALSE(stage_->Map(cancelled, surface).ok());
  const auto map = stage_->Map({}, surface);
  ASSERT_TRUE(map.ok()) << map.status();
  EXPECT_EQ(*map, *stage_->Map({}, surface));
}

/// Two jobs use one surface. The second one may end while the first one's map is being made.
TEST_F(LocalTextureTest, WaitingForAMapCanBeCancelled) {
  const Shared<SurfaceInput> surface(SurfaceInput{Strip()});
  std::promise<void> begun, second_ended;
  const std::shared_future<void> ended = second_ended.get_future();
  bool is_first_look = true;
  StageCall first;
  first.cancel = CancelToken([&] {  // called while the map is made
    if (std::exchange(is_first_look, false)) begun.set_value();
    return ended.wait_for(std::chrono::seconds(60)) != std::future_status::ready;
  });
  auto made = std::async(std::launch::async, [&] { return stage_->Map(first, surface).status(); });
  begun.get_future().wait();
  StageCall second;
  second.cancel = CancelToken([] { return true; });
  EXPECT_EQ(stage_->Map(second, surface).status().code(), absl::StatusCode::kCancelled);
  second_ended.set_value();
  EXPECT_EQ(made.get(), absl::OkStatus());
}

}  // namespace
}  // namespace slicefarm::texture::local_texture_stage_test
