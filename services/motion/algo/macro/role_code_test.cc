#include "services/motion/algo/macro/role_code.h"

#include <gtest/gtest.h>

#include <span>

namespace slicefarm::motion::role_code_test {
namespace {

macro::Template Parsed(const std::string& text) {
  macro::Template code;
  const macro::TemplateTarget places[] = {{"change_extrusion_role_gcode", text, code}};
  EXPECT_TRUE(macro::ParseTemplates(std::span(places)).ok());
  return code;
}

TEST(RoleTextsOf, NamesBothFeatures) {
  const auto role = [](Feature feature) { return static_cast<int32_t>(feature); };
  const std::set<RoleChange> changes = {
      {-1, role(Feature::kExternalPerimeter)},
      {role(Feature::kExternalPerimeter), role(Feature::kInternalBridge)}};
  const auto texts =
      RoleTextsOf(Parsed("; [last_extrusion_role] to {extrusion_role} at {layer_num}"), changes, {},
                  {{"layer_num", int64_t{7}}});
  ASSERT_TRUE(texts.ok()) << texts.status();
  EXPECT_EQ(texts->at({-1, role(Feature::kExternalPerimeter)}), ";  to ExternalPerimeter at 7");
  EXPECT_EQ(texts->at({role(Feature::kExternalPerimeter), role(Feature::kInternalBridge)}),
            "; ExternalPerimeter to BridgeInfill at 7");
}

TEST(RoleTextsOf, RefusesUnknownNames) {
  EXPECT_FALSE(RoleTextsOf(Parsed("{no_such_name}"), {{-1, 0}}, {}, {}).ok());
}

}  // namespace
}  // namespace slicefarm::motion::role_code_test
