#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

#include "common/base/error.h"
#include "processes/engrave/task/engrave_chain.h"
#include "services/slicing/algo/placement/local_placing_stage.h"
#include "services/texture/algo/local_texture_stage.h"
#include "tests/integration/fake_stages.h"
#include "tests/integration/remote_clients.h"
#include "tests/integration/stage_host.h"
#include "tests/integration/whole_job.h"

namespace slicefarm::engrave_local_and_remote_test {
namespace {

/// Returns a bent strip.
SurfaceMesh Strip() {
  SurfaceMesh mesh;
  constexpr int kColumns = 12, kRows = 8;
  for (int j = 0; j <= kRows; ++j)
    for (int i = 0; i <= kColumns; ++i) mesh.points_mm.push_back({i / 3.0, j / 3.0, 0.05 * i * i});
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const int a = j * (kColumns + 1) + i, b = a + kColumns + 1;
      mesh.triangles.push_back({a, a + 1, b + 1});
      mesh.triangles.push_back({a, b + 1, b});
    }
  }
  return mesh;
}

/// Compares reading and engraving in this process with the same behind a socket, and with a worker
/// that engraves.
class EngraveLocalAndRemote : public testing::Test {
 protected:
  EngraveLocalAndRemote() {
    const auto mapped = texture_->Map(call_, surface_);
    EXPECT_TRUE(mapped.ok()) << mapped.status();
    EngraveInput input;
    input.settings.format = EngraveFormat::kGcode;
    input.settings.texture.texture = "bumps:pitch=1,height=0.3";
    input.settings.lines.spacing = "0.2";
    input.surface = *mapped;
    input_ = Shared<EngraveInput>(input);
  }

  HostedStages Hosted() const {
    HostedStages hosted{fakes_.slicing,  fakes_.beading, fakes_.infill,
                        fakes_.ordering, fakes_.motion,  chain_};
    hosted.texture = texture_.get();
    return hosted;
  }

  struct Fakes {
    FakeStages fakes;
    FakeSlicing slicing{fakes};
    FakeBeading beading{fakes};
    FakeInfill infill{fakes};
    FakeOrdering ordering{fakes};
    FakeMotion motion{fakes};
  } fakes_;
  const std::unique_ptr<PlacingStage> placing_ = slicing::MakeLocalPlacing();
  const std::unique_ptr<TextureStage> texture_ = texture::MakeLocalTexture();
  const EngraveChain chain_{*texture_};
  StageHost host_{Hosted()};
  const RemoteClients remote_{host_.Address()};
  const StageCall call_;
  const Shared<SurfaceInput> surface_{SurfaceInput{Strip()}};
  Shared<EngraveInput> input_;
};

TEST_F(EngraveLocalAndRemote, SurfacesAreTheSame) {
  const auto here = placing_->ReadSurfaces(call_, TextBox(), SlicingOptions());
  const auto there = remote_.placing.ReadSurfaces(call_, TextBox(), SlicingOptions());
  ASSERT_TRUE(here.ok()) << here.status();
  ASSERT_TRUE(there.ok()) << there.status();
  EXPECT_EQ(*there, *here);
  EXPECT_FALSE(here->front().triangles.empty());
}

TEST_F(EngraveLocalAndRemote, MapsAreTheSame) {
  const auto there = remote_.texture.Map(call_, surface_);
  ASSERT_TRUE(there.ok()) << there.status();
  EXPECT_EQ(*there, input_->surface);
}

TEST_F(EngraveLocalAndRemote, RangesElsewhereGiveTheSameLayers) {
  const auto layout = texture_->LayOut(call_, input_);
  ASSERT_TRUE(layout.ok()) << layout.status();
  const auto there = remote_.texture.LayOut(call_, input_);
  ASSERT_TRUE(there.ok()) << there.status();
  EXPECT_EQ(*there, *layout);
  const auto all = texture_->Engrave(call_, input_, {0, layout->layer_count});
  ASSERT_TRUE(all.ok()) << all.status();
  for (const int32_t cut : {1, layout->layer_count / 2}) {
    std::vector<EngravedLayer> staged, worked;
    for (const LayerRange range : {LayerRange{0, cut}, LayerRange{cut, layout->layer_count}}) {
      auto layers = remote_.texture.Engrave(call_, input_, range);
      ASSERT_TRUE(layers.ok()) << layers.status();
      std::ranges::move(*layers, std::back_inserter(staged));
      auto result = remote_.worker.RunTask(call_, EngraveTask{range, input_});
      ASSERT_TRUE(result.ok()) << result.status();
      std::ranges::move(result->As<EngraveResult>().layers, std::back_inserter(worked));
    }
    EXPECT_EQ(staged, *all) << cut;
    EXPECT_EQ(worked, *all) << cut;
  }
  EXPECT_EQ(host_.shared().counts().entries, 1) << "the input was sent once";
}

/// Binary files are transferred as bytes.
TEST_F(EngraveLocalAndRemote, WholeFilesAreTheSame) {
  for (const EngraveFormat format : {EngraveFormat::kStl, EngraveFormat::kPng}) {
    EngraveInput input = *input_;
    input.settings.format = format;
    const Shared<EngraveInput> shared(input);
    const auto here = texture_->Engrave(call_, shared, {0, 1});
    ASSERT_TRUE(here.ok()) << here.status();
    ASSERT_EQ(here->size(), 1u);
    EXPECT_GT(here->front().text.size(), 1000u);
    const auto there = remote_.texture.Engrave(call_, shared, {0, 1});
    ASSERT_TRUE(there.ok()) << there.status();
    EXPECT_EQ(*there, *here);
    auto worked = remote_.worker.RunTask(call_, EngraveTask{{0, 1}, shared});
    ASSERT_TRUE(worked.ok()) << worked.status();
    EXPECT_EQ(worked->As<EngraveResult>().layers, *here);
  }
}

TEST_F(EngraveLocalAndRemote, RefusesTheSameHereAndThere) {
  EngraveInput wrong = *input_;
  wrong.settings.texture.texture = "bumps:pitch=none";
  const absl::Status here = texture_->LayOut(call_, wrong).status();
  EXPECT_EQ(remote_.texture.LayOut(call_, wrong).status().message(), here.message());
  EXPECT_FALSE(here.ok());
  EXPECT_EQ(DetailOf(remote_.texture.Engrave(call_, input_, {0, 100}).status()).reason,
            Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::engrave_local_and_remote_test
