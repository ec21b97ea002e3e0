#include "processes/fdm/settings/table/scopes.h"

#include <gtest/gtest.h>

#include "common/config/table/settings_table.h"

namespace slicefarm::config::fdm::scopes_test {
namespace {

Scope ScopeOf(std::string_view key) {
  const int index = FindSetting(key, Process::kFdm);
  EXPECT_GE(index, 0) << key;
  return index < 0 ? Scope::kJob : SettingsTable(Process::kFdm)[index].scope;
}

TEST(SetScopes, AsPrusaSlicerHasThem) {
  for (const char* key : {"fill_density", "perimeters"}) EXPECT_EQ(ScopeOf(key), Scope::kRegion);
  for (const char* key : {"layer_height", "slicing_mode", "seam_position", "raft_layers",
                          "brim_ears_max_angle", "support_material_angle"})
    EXPECT_EQ(ScopeOf(key), Scope::kObject) << key;
  for (const char* key : {"skirts", "first_layer_height", "temperature"})
    EXPECT_EQ(ScopeOf(key), Scope::kJob) << key;
}

// The lists are looked up by bisection.
TEST(SetScopes, FindsAllThatTheListsSay) {
  int regions = 0, objects = 0;
  for (const SettingSpec& spec : SettingsTable(Process::kFdm)) {
    regions += spec.scope == Scope::kRegion;
    objects += spec.scope == Scope::kObject;
  }
  EXPECT_EQ(regions, 79);
  EXPECT_EQ(objects, 64);
}

}  // namespace
}  // namespace slicefarm::config::fdm::scopes_test
