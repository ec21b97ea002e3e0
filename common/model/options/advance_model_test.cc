#include "common/model/options/advance_model.h"

#include <gtest/gtest.h>

namespace slicefarm::advance_model_test {
namespace {

AdvanceModel ModelOf(std::string_view text) {
  const auto points = ParseAdvancePoints(text);
  EXPECT_TRUE(points.ok()) << points.status();
  return AdvanceModel(points.ok() ? *points : std::vector<AdvancePoint>{});
}

TEST(AdvanceModel, GivesMeasuredValues) {
  const AdvanceModel model =
      ModelOf("0.04,3.96,3000;0.033,3.96,10000;0.029,7.91,3000;0.026,7.91,10000");
  EXPECT_EQ(model.At(3.96, 3000), 0.04);
  EXPECT_EQ(model.At(3.96, 10'000), 0.033);
  EXPECT_EQ(model.At(7.91, 3000), 0.029);
  EXPECT_EQ(model.At(7.91, 10'000), 0.026);
}

TEST(AdvanceModel, StaysAtItsEndsOutsideTheMeasuredRange) {
  const AdvanceModel model = ModelOf("0.04,4,3000;0.03,8,3000;0.03,4,6000;0.02,8,6000");
  EXPECT_EQ(model.At(0.1, 3000), 0.04);
  EXPECT_EQ(model.At(100, 3000), 0.03);
  EXPECT_EQ(model.At(4, 1), 0.04);
  EXPECT_EQ(model.At(8, 1e6), 0.02);
}

TEST(AdvanceModel, InterpolatesTwoPointsLinearly) {
  const AdvanceModel model = ModelOf("0.04,4,3000;0.02,8,3000;0.03,4,5000;0.01,8,5000");
  EXPECT_EQ(model.At(6, 3000), 0.03);
  EXPECT_EQ(model.At(4, 4000), 0.035);
}

TEST(AdvanceModel, FallsSteadilyBetweenFallingPoints) {
  const AdvanceModel model = ModelOf("0.08,2,3000;0.079,4,3000;0.03,6,3000;0.029,12,3000");
  double last = 0.08;
  for (double flow = 2; flow <= 12; flow += 0.25) {
    const double now = model.At(flow, 3000);
    EXPECT_LE(now, last) << flow;
    EXPECT_GE(now, 0.029) << flow;
    last = now;
  }
  EXPECT_EQ(last, 0.029);
}

TEST(AdvanceModel, NeedsTwoPointsOfOneAcceleration) {
  EXPECT_TRUE(ModelOf("").empty());
  EXPECT_TRUE(ModelOf("0.04,4,3000;0.03,8,5000").empty());
  const AdvanceModel one = ModelOf("0.04,4,3000;0.03,8,3000;0.9,4,5000");
  EXPECT_EQ(one.At(4, 5000), 0.04);  // the curve of 5000 mm/s2 has one point only
}

TEST(AdvancePoints, ParsePrintedText) {
  constexpr std::string_view kText = "0.04,3.96,3000;0.033,3.96,10000";
  EXPECT_EQ(PrintAdvancePoints(*ParseAdvancePoints(kText)), kText);
  EXPECT_EQ(PrintAdvancePoints(*ParseAdvancePoints(" \"0.04, 3.96,3000\" ;;")), "0.04,3.96,3000");
  EXPECT_TRUE(ParseAdvancePoints("")->empty());
}

TEST(AdvancePoints, RejectBadText) {
  for (const std::string_view text :
       {"0.04", "0.04,3", "0.04,3,x", "0.04,3,3000,1", "-0.04,3,3000", "0.04,3,3000;0.05,3,3000"})
    EXPECT_FALSE(ParseAdvancePoints(text).ok()) << text;
}

}  // namespace
}  // namespace slicefarm::advance_model_test
