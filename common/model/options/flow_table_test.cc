#include "common/model/options/flow_table.h"

#include <gtest/gtest.h>

namespace slicefarm::flow_table_test {
namespace {

TEST(FlowTable, GoesInProportionBetweenItsPoints) {
  const auto table = ParseFlowTable("0,0.2;1,0.6;5,1");
  ASSERT_TRUE(table.ok()) << table.status();
  const std::pair<double, double> cases[] = {{-1, 0.2}, {0, 0.2}, {0.5, 0.4}, {1, 0.6},
                                             {3, 0.8},  {4, 0.9}, {5, 1},     {100, 1}};
  for (const auto& [length_mm, factor] : cases)
    EXPECT_DOUBLE_EQ(FlowAt(*table, length_mm), factor) << length_mm;
}

TEST(FlowTable, TheStandardRisesToAllOfThePlastic) {
  const auto table = ParseFlowTable(kSmallAreaFlowTable);
  ASSERT_TRUE(table.ok()) << table.status();
  EXPECT_EQ(table->size(), 10);
  double before = -1;
  for (const FlowPoint& point : *table) {
    EXPECT_GT(point.factor, before);
    before = point.factor;
  }
}

TEST(FlowTable, IsPrintedAsItIsRead) {
  EXPECT_EQ(PrintFlowTable(*ParseFlowTable(kSmallAreaFlowTable)), kSmallAreaFlowTable);
  // A list as OrcaSlicer writes it.
  EXPECT_EQ(PrintFlowTable(*ParseFlowTable("\"0,0\";\"\n0.20, 0.5\" ; \n1.0,1.0")),
            "0,0;0.2,0.5;1,1");
  // A list of Creality's presets in OrcaSlicer, with line breaks as two characters.
  EXPECT_EQ(PrintFlowTable(*ParseFlowTable(R"(0,0;"\n0.2,0.5";\n1,1)")), "0,0;0.2,0.5;1,1");
  EXPECT_EQ(PrintFlowTable(*ParseFlowTable("-0,-0;1,1")), "0,0;1,1");
}

TEST(FlowTable, RefusesWhatIsNone) {
  for (const char* text :
       {"", "0,0", "0,1", ";", "0,0;", "0,0;1", "0,0;1,1,1", "x,0;1,1", "0.1,0;1,1", "0,0;1,0.5",
        "0,0;1,0.5;1,1", "0,0;2,0.5;1,1", "0,-0.1;1,1", "0,2.1;1,1", "0,0;1001,1", "0,nan;1,1"})
    EXPECT_FALSE(ParseFlowTable(text).ok()) << text;
  std::string many = "0,0";
  for (int i = 1; i < kMaxFlowPoints; ++i) many += ";" + std::to_string(i) + ",1";
  EXPECT_TRUE(ParseFlowTable(many).ok());
  EXPECT_FALSE(ParseFlowTable(many + ";200,1").ok());
}

}  // namespace
}  // namespace slicefarm::flow_table_test
