#include "services/slicing/algo/mesh_io/threemf/settings/setting_list.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::slicing::threemf::setting_list_test {
namespace {

TEST(AddSetting, AddsAProfilesSetting) {
  std::vector<Setting> settings;
  ASSERT_TRUE(AddSetting("layer_height", "0.2", settings).ok());
  EXPECT_EQ(settings[0], (Setting{"layer_height", "0.2", Source::kProfile}));
  EXPECT_EQ(DetailOf(AddSetting("", "1", settings)).reason, Reason::kMeshMalformed);
  EXPECT_EQ(DetailOf(AddSetting("a", std::string(70'000, 'x'), settings)).reason,
            Reason::kMeshTooLarge);
  while (settings.size() < 2000) ASSERT_TRUE(AddSetting("a", "", settings).ok());
  EXPECT_EQ(DetailOf(AddSetting("a", "", settings)).reason, Reason::kMeshTooLarge);
}

TEST(NamesScripts, KnowsThem) {
  EXPECT_TRUE(NamesScripts("post_process"));
  EXPECT_FALSE(NamesScripts("start_gcode"));
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::setting_list_test
