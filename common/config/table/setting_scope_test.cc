#include "common/config/table/setting_scope.h"

#include <gtest/gtest.h>

#include "common/config/table/settings_table.h"

namespace slicefarm::config::setting_scope_test {
namespace {

TEST(ScopeOf, AsPrusaSlicerHasIt) {
  EXPECT_EQ(ScopeOf("fill_density"), Scope::kRegion);
  EXPECT_EQ(ScopeOf("perimeters"), Scope::kRegion);
  EXPECT_EQ(ScopeOf("layer_height"), Scope::kObject);
  EXPECT_EQ(ScopeOf("seam_position"), Scope::kObject);
  EXPECT_EQ(ScopeOf("raft_layers"), Scope::kObject);
  EXPECT_EQ(ScopeOf("brim_ears_max_angle"), Scope::kObject);
  EXPECT_EQ(ScopeOf("support_material_angle"), Scope::kObject);
  EXPECT_EQ(ScopeOf("skirts"), Scope::kJob);
  EXPECT_EQ(ScopeOf("first_layer_height"), Scope::kJob);
  EXPECT_EQ(ScopeOf("temperature"), Scope::kJob);
  EXPECT_EQ(ScopeOf("no_such_setting"), Scope::kJob);
}

// The lists are looked up by bisection.
TEST(ScopeOf, FindsAllThatTheTableSays) {
  int regions = 0, objects = 0;
  for (const SettingSpec& spec : SettingsTable()) {
    EXPECT_EQ(spec.scope, ScopeOf(spec.key)) << spec.key;
    regions += spec.scope == Scope::kRegion;
    objects += spec.scope == Scope::kObject;
  }
  EXPECT_GE(regions, 70);
  EXPECT_GE(objects, 16);
}

}  // namespace
}  // namespace slicefarm::config::setting_scope_test
