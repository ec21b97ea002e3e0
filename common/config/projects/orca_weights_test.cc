#include "common/config/projects/orca_weights.h"

#include <gtest/gtest.h>

#include "common/config/table/orca_table.h"

namespace slicefarm::config::orca_weights_test {
namespace {

TEST(WeightOf, DependsOnTheValue) {
  struct Case {
    const char* key;
    const char* value;
    OrcaWeight weight;
  };
  for (const Case& c : {Case{"post_process", "", OrcaWeight::kNothing},
                        Case{"post_process", R"(["a.py"])", OrcaWeight::kPrint},
                        Case{"temperature_vitrification", "60", OrcaWeight::kNothing},
                        Case{"nozzle_volume", "92", OrcaWeight::kNothing},
                        Case{"overhang_totally_speed", "10", OrcaWeight::kDetail}})
    EXPECT_EQ(WeightOf(c.key, c.value), c.weight) << c.key << " = " << c.value;
}

TEST(WhyIdle, GivesAReason) {
  EXPECT_EQ(WhyIdle("overhang_totally_speed"), "acts in Bambu Studio only");
  EXPECT_EQ(WhyIdle("no_such_key"),
            "no setting of OrcaSlicer, which ignores it (as of February 2026)");
}

TEST(WeightOf, KnowsNoSettingThatHasACounterpart) {
  ASSERT_FALSE(OrcaRows().empty());
  for (const OrcaRow& row : OrcaRows())
    EXPECT_EQ(WeightOf(row.from, "?"), OrcaWeight::kDetail) << row.from;
}

}  // namespace
}  // namespace slicefarm::config::orca_weights_test
