#include "services/infill/algo/infill_check.h"

#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill::infill_check_test {
namespace {

TEST(CheckFlows, RefusesATableThatIsNotOne) {
  InfillOptions options;
  options.small_area_flow = true;
  options.small_area_flow_table = std::string("nonsense");
  const absl::Status status = CheckFlows(options);
  EXPECT_EQ(DetailOf(status).reason, Reason::kSettingMalformed);
  EXPECT_EQ(DetailOf(status).metadata.at("setting"), "small_area_infill_flow_compensation_model");
}

TEST(CheckFlows, IgnoresTheTableOfACompensationThatIsOff) {
  InfillOptions options;
  options.small_area_flow_table = std::string("nonsense");
  EXPECT_TRUE(CheckFlows(options).ok());
  EXPECT_TRUE(FlowsOf(options).empty());
}

TEST(FlowsOf, ReturnsTheFactorsOfTheTable) {
  InfillOptions options;
  options.small_area_flow = true;
  options.small_area_flow_table = std::string("0,0;10,1");
  ASSERT_TRUE(CheckFlows(options).ok()) << CheckFlows(options);
  EXPECT_EQ(FlowsOf(options).size(), 2);
}

}  // namespace
}  // namespace slicefarm::infill::infill_check_test
