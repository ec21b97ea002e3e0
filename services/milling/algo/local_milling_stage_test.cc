#include "services/milling/algo/local_milling_stage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "services/milling/algo/sample_inputs_test.h"

namespace slicefarm::milling::local_milling_stage_test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class LocalMillingTest : public testing::Test {
 protected:
  std::vector<MilledStep> All(int32_t cut = 1'000) const {
    std::vector<MilledStep> steps;
    const auto count = static_cast<int32_t>(stage_->LayOut({}, input_)->steps.size());
    for (int32_t first = 0; first < count; first += cut) {
      auto some = stage_->Mill({}, input_, {first, std::min(first + cut, count)});
      EXPECT_TRUE(some.ok()) << some.status();
      std::move(some->begin(), some->end(), std::back_inserter(steps));
    }
    return steps;
  }

  std::unique_ptr<MillingStage> stage_ = MakeLocalMilling();
  MillInput given_ = InputOf(PocketPart().Mesh(), OptionsFor("cyl:1"));
  Shared<MillInput> input_{given_};
};

TEST_F(LocalMillingTest, MakesProgramsFromAnyRanges) {
  const auto layout = stage_->LayOut({}, input_);
  ASSERT_TRUE(layout.ok()) << layout.status();
  EXPECT_EQ(layout->weights.size(), layout->steps.size());
  EXPECT_EQ(layout->stock_mm.max().z(), 4);
  const auto whole = stage_->Assemble({}, input_, All(), "stepdown = 1\nfeed = 800\n");
  ASSERT_TRUE(whole.ok()) << whole.status();
  EXPECT_THAT(whole->text, StartsWith("; tool 1: cyl:1, 12000 rpm\n; stock: x -1.000 to 10.000"));
  EXPECT_THAT(whole->text, HasSubstr("M2\n; stepdown = 1\n; feed = 800\n"));
  EXPECT_EQ(whole->report.gouges, 0);
  EXPECT_GT(whole->report.checked, 0);
  for (const int32_t cut : {1, 7})
    EXPECT_EQ(stage_->Assemble({}, input_, All(cut), "stepdown = 1\nfeed = 800\n")->text,
              whole->text);
  given_.settings.dialect = MillDialect::kGrbl;
  input_ = given_;
  EXPECT_THAT(stage_->Assemble({}, input_, All(), "")->text, testing::Not(HasSubstr("G64")));
}

TEST_F(LocalMillingTest, DrawsOneStep) {
  given_.settings.format = MillFormat::kSvg;
  given_.settings.output_step = 2;
  input_ = given_;
  const auto picture = stage_->Assemble({}, input_, *stage_->Mill({}, input_, {2, 3}), "");
  ASSERT_TRUE(picture.ok()) << picture.status();
  EXPECT_THAT(picture->text, StartsWith("<svg"));
  given_.settings.output_step = 100'000;
  input_ = given_;
  const ErrorDetail detail = DetailOf(stage_->LayOut({}, input_).status());
  EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(detail.metadata.at("setting"), "output_step");
}

TEST_F(LocalMillingTest, RefusesWhatIsNotOfTheJob) {
  for (const StepRange range : {StepRange{-1, 2}, StepRange{3, 2}, StepRange{0, 100'000}})
    EXPECT_EQ(DetailOf(stage_->Mill({}, input_, range).status()).reason, Reason::kRequestMalformed);
  std::vector<MilledStep> steps = All();
  steps.pop_back();
  EXPECT_EQ(DetailOf(stage_->Assemble({}, input_, steps, "").status()).reason,
            Reason::kRequestMalformed);
  steps.push_back(steps.front());
  EXPECT_EQ(DetailOf(stage_->Assemble({}, input_, steps, "").status()).reason,
            Reason::kRequestMalformed);
}

TEST_F(LocalMillingTest, StopsWhenCancelled) {
  StageCall call;
  call.cancel = CancelToken([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(stage_->LayOut(call, input_).status()));
  ASSERT_TRUE(stage_->LayOut({}, input_).ok());
  EXPECT_TRUE(absl::IsCancelled(stage_->Mill(call, input_, {0, 1}).status()));
  EXPECT_TRUE(absl::IsCancelled(stage_->Assemble(call, input_, All(), "").status()));
}

}  // namespace
}  // namespace slicefarm::milling::local_milling_stage_test
