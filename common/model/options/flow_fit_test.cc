#include "common/model/options/flow_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace slicefarm::flow_fit_test {
namespace {

TEST(FlowFit, AddsItsTerms) {
  const struct {
    std::string text;
    double flow;
  } cases[] = {{"1 0 0 0 0 0", 0.04}, {"0 1 0 0 0 0", 0.25},      {"0 0 1 0 0 0", 0.1},
               {"0 0 0 1 0 0", 0.2},  {"0 0 0 0 1 0", 0.5},       {"0 0 0 0 0 1", 1},
               {"1 1 1 1 1 1", 2.09}, {"  -1 0 0 0 0   8 ", 7.96}};
  for (const auto& [text, flow] : cases)
    EXPECT_NEAR(FlowFit::Parse(text)->At(0.2, 0.5), flow, 1e-12) << text;
}

TEST(FlowFit, HasNoLimitWithoutFactorsAndBelowZero) {
  for (const char* text : {"", "  ", "0 0 0 0 0 0", "0 0 0 0 0 -1"})
    EXPECT_TRUE(std::isinf(FlowFit::Parse(text)->At(0.2, 0.5))) << text;
}

TEST(FlowFit, RefusesOtherTexts) {
  for (const char* text : {"1", "1 2 3 4 5", "1 2 3 4 5 6 7", "1 2 3 4 5 x", "1 2 3 4 5 inf"})
    EXPECT_FALSE(FlowFit::Parse(text).ok()) << text;
}

}  // namespace
}  // namespace slicefarm::flow_fit_test
