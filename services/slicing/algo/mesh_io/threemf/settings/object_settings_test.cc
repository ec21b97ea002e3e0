#include "services/slicing/algo/mesh_io/threemf/settings/object_settings.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"

namespace slicefarm::slicing::threemf::object_settings_test {
namespace {

std::string TextOf(const Files& files, std::string_view name) {
  for (const auto& [each, text] : files)
    if (each == name) return text;
  return "";
}

TEST(ReadModelSettings, ReadsPrusaSlicersVolumes) {
  const auto settings =
      ReadModelSettings(TextOf(PrusaFiles(), "Metadata/Slic3r_PE_model.config"), "config");
  ASSERT_TRUE(settings.ok()) << settings.status();
  const ObjectSettings* bracket = settings->Of(1);
  ASSERT_NE(bracket, nullptr);
  EXPECT_EQ(bracket->name, "Bracket");
  EXPECT_EQ(bracket->settings, (std::vector<Setting>{{"perimeters", "4", Source::kProfile}}));
  ASSERT_EQ(bracket->parts.size(), 2u);
  EXPECT_EQ(bracket->parts[0].name, "body");
  EXPECT_EQ(bracket->parts[0].role, PartRole::kSolid);
  EXPECT_TRUE(bracket->parts[0].settings.empty()) << "the matrix and the source are notes";
  EXPECT_EQ(bracket->parts[1].role, PartRole::kModifier);
  EXPECT_EQ(bracket->parts[1].first_triangle, 12);
  EXPECT_EQ(bracket->parts[1].last_triangle, 23);
  EXPECT_EQ(bracket->parts[1].settings,
            (std::vector<Setting>{{"fill_density", "80%", Source::kProfile}}));
  EXPECT_EQ(settings->Of(2), nullptr);
  EXPECT_TRUE(settings->plates.empty());
}

TEST(ReadModelSettings, ReadsBambusPartsAndPlates) {
  const auto settings =
      ReadModelSettings(TextOf(BambuFiles(), "Metadata/model_settings.config"), "config");
  ASSERT_TRUE(settings.ok()) << settings.status();
  const ObjectSettings* cube = settings->Of(2);
  ASSERT_NE(cube, nullptr);
  ASSERT_EQ(cube->parts.size(), 2u);
  EXPECT_EQ(cube->parts[1].component, 3u);
  EXPECT_EQ(cube->parts[1].role, PartRole::kNegative);
  ASSERT_EQ(settings->plates.size(), 2u);
  EXPECT_EQ(settings->plates[0].name, "left");
  EXPECT_FALSE(settings->plates[0].locked);
  EXPECT_TRUE(settings->plates[1].locked);
  EXPECT_EQ(settings->plates[1].number, 2);
  EXPECT_EQ(settings->plates[1].settings,
            (std::vector<Setting>{{"spiral_mode", "1", Source::kProfile}}));
  ASSERT_EQ(settings->plates[1].members.size(), 1u);
  EXPECT_EQ(settings->plates[1].members[0].object, 2u);
  EXPECT_EQ(settings->plates[1].members[0].instance, 1);
}

TEST(ReadModelSettings, KnowsAllRoles) {
  struct Case {
    std::string volume, part;
    PartRole want;
  };
  for (const Case& c : std::initializer_list<Case>{
           {"ModelPart", "normal_part", PartRole::kSolid},
           {"NegativeVolume", "negative_part", PartRole::kNegative},
           {"ParameterModifier", "modifier_part", PartRole::kModifier},
           {"SupportEnforcer", "support_enforcer", PartRole::kSupportEnforcer},
           {"SupportBlocker", "support_blocker", PartRole::kSupportBlocker},
           {"SeamEnforcer", "seam_enforcer", PartRole::kSeamEnforcer},
           {"SeamBlocker", "seam_blocker", PartRole::kSeamBlocker}}) {
    const std::string head = "<config><object id='1'>", tail = "</object></config>";
    const auto volume = ReadModelSettings(
        head + "<volume firstid='0' lastid='1'><metadata key='volume_type' value='" + c.volume +
            "'/></volume>" + tail,
        "config");
    ASSERT_TRUE(volume.ok()) << volume.status();
    EXPECT_EQ(volume->objects[0].parts[0].role, c.want) << c.volume;
    const auto part =
        ReadModelSettings(head + "<part id='1' subtype='" + c.part + "'/>" + tail, "config");
    ASSERT_TRUE(part.ok()) << part.status();
    EXPECT_EQ(part->objects[0].parts[0].role, c.want) << c.part;
  }
}

TEST(ReadModelSettings, NeverReadsScripts) {
  const auto settings = ReadModelSettings(
      "<config><object id='1'><metadata key='post_process' value='evil'/></object></config>", "c");
  ASSERT_TRUE(settings.ok()) << settings.status();
  EXPECT_TRUE(settings->objects[0].settings.empty());
  EXPECT_TRUE(settings->has_scripts);
}

TEST(ReadModelSettings, SaysWhatIsWrong) {
  for (const std::string inside :
       {"<object/>", "<object id='0'/>", "<object id='-1'/>", "<object id='9999999999'/>",
        "<object id='x'/>", "<object id='1'><volume firstid='0'/></object>",
        "<object id='1'><volume firstid='-1' lastid='2'/></object>",
        "<object id='1'><volume firstid='0' lastid='1e3'/></object>",
        "<object id='1'><part/></object>", "<object id='1'><part id='1' subtype='odd'/></object>",
        "<plate><metadata key='plater_id' value='one'/></plate>",
        "<plate><model_instance><metadata key='object_id' value=''/></model_instance></plate>"}) {
    const auto settings =
        ReadModelSettings("<config>\n" + std::string(inside) + "</config>", "config");
    ASSERT_FALSE(settings.ok()) << inside;
    EXPECT_EQ(DetailOf(settings.status()).reason, Reason::kMeshMalformed) << inside;
    EXPECT_EQ(DetailOf(settings.status()).metadata["line"], "2") << inside;
  }
}

TEST(ReadModelSettings, PassesOverWhatStandsElsewhere) {
  for (const std::string text :
       {"<config><metadata key='a' value='1'/></config>",
        "<config><x><volume><metadata key='a' value='1'/></volume></x></config>",
        "<config><plate><part><metadata key='a' value='1'/></part></plate></config>",
        "<object><metadata key='a' value='1'/></object>",
        "<config><x><model_instance><metadata key='object_id' "
        "value='1'/></model_instance></x></config>"})
    EXPECT_TRUE(ReadModelSettings(text, "config").ok()) << text;
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::object_settings_test
