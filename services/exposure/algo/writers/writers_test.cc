#include "services/exposure/algo/writers/writers.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/exposure/algo/writers/number_text.h"
#include "services/exposure/algo/writers/sample_layers_test.h"

namespace slicefarm::exposure {
namespace {

std::string SettingOf(const absl::Status& status) {
  const ErrorDetail detail = DetailOf(status);
  EXPECT_EQ(detail.reason, Reason::kSettingOutOfRange) << status;
  return detail.metadata.contains("setting") ? detail.metadata.at("setting") : "";
}

TEST(CheckOutput, NamesWhatAFormatCannotSay) {
  EXPECT_TRUE(CheckOutput(SampleFacts(OutputFormat::kGrbl)).ok());
  FileFacts facts = SampleFacts(OutputFormat::kGrbl);
  facts.output.full_power_w = 150;  // hatch has 200
  EXPECT_EQ(SettingOf(CheckOutput(facts)), "power_w");
  facts.output.format = OutputFormat::kSvg;
  EXPECT_TRUE(CheckOutput(facts).ok());
  facts.output.full_power_w = 0;
  EXPECT_EQ(SettingOf(CheckOutput(facts)), "full_power_w");
  facts = SampleFacts(OutputFormat::kDxf);
  facts.output.layer = 2;
  EXPECT_EQ(SettingOf(CheckOutput(facts)), "layer");
  facts = SampleFacts(OutputFormat::kCliAscii);
  facts.output.unit_mm = 0;
  EXPECT_EQ(SettingOf(CheckOutput(facts)), "unit_mm");
  facts = SampleFacts(OutputFormat::kCliAscii);
  facts.output.full_power_s = -1;
  EXPECT_EQ(SettingOf(CheckOutput(facts)), "full_power_s");
}

TEST(NumberText, Rounds) {
  const auto mm = [](Coord nm, int decimals) {
    std::string text;
    AppendMm(text, nm, decimals);
    return text;
  };
  EXPECT_EQ(mm(1'500'000, 6), "1.5");
  EXPECT_EQ(mm(-1'500'001, 6), "-1.500001");
  EXPECT_EQ(mm(0, 4), "0");
  EXPECT_EQ(mm(49, 4), "0");
  EXPECT_EQ(mm(-49, 4), "0");
  EXPECT_EQ(mm(50, 4), "0.0001");
  EXPECT_EQ(mm(-50, 4), "-0.0001");
  EXPECT_EQ(mm(999'999'950, 4), "1000");
  EXPECT_EQ(mm(10'000'000, 0), "10");
  EXPECT_EQ(mm(10'060'000, 2), "10.06");
}

}  // namespace
}  // namespace slicefarm::exposure
