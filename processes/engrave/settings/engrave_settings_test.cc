#include "processes/engrave/settings/engrave_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/config/resolve.h"
#include "common/config/setting_pairs_test.h"
#include "processes/engrave/model/engrave_settings.h"

namespace slicefarm::config::engrave::engrave_settings_test {
namespace {

absl::StatusOr<ResolvedSettings> OfEngrave(const Pairs& given) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : given) settings.push_back({key, value, Source::kRequest});
  return Resolve(settings, Process::kEngrave);
}

TEST(ResolveEngrave, SettingsReachTheirOptions) {
  const auto resolved = OfEngrave({{"texture", "knurl:pitch=2"},
                                   {"anchor", "1,2,3"},
                                   {"spacing", "0.1,0.2"},
                                   {"normals", "interpolated"},
                                   {"axes", "head-ab"},
                                   {"output_format", "gcode"}});
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  const EngraveSettings& engrave = EngraveOf(resolved->settings);
  EXPECT_EQ(engrave.texture.texture, "knurl:pitch=2");
  EXPECT_EQ(engrave.texture.anchor, "1,2,3");
  EXPECT_EQ(engrave.lines.spacing, "0.1,0.2");
  EXPECT_EQ(engrave.lines.normals, NormalKind::kInterpolated);
  EXPECT_EQ(engrave.machine.axes, AxisLayout::kHeadAb);
  EXPECT_EQ(engrave.format, EngraveFormat::kGcode);
  EXPECT_THAT(TextsOf(resolved->no_effect), testing::IsEmpty());
}

// The default values in the table equal the default values of the options.
TEST(ResolveEngrave, StandardsAreTheDefaults) {
  const auto resolved = OfEngrave({});
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  EXPECT_EQ(EngraveOf(resolved->settings), EngraveSettings());
}

TEST(ResolveEngrave, NamesTextsThatCannotBeRead) {
  EXPECT_EQ(DetailOf(OfEngrave({{"orient", "up"}}).status()).metadata["setting"], "orient");
  EXPECT_EQ(DetailOf(OfEngrave({{"mask_image", "!"}}).status()).metadata["setting"], "mask_image");
}

TEST(ResolveEngrave, AMachineNeedsAProgram) {
  const auto resolved = OfEngrave({{"axes", "none"}});
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  EXPECT_THAT(TextsOf(resolved->no_effect),
              testing::ElementsAre("axes = none: needs output_format = gcode"));
}

TEST(ResolveEngrave, AnEdgeNeedsAMesh) {
  const auto mesh = OfEngrave({{"output_format", "obj"}, {"displaced_edge", "0.5"}});
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_EQ(EngraveOf(mesh->settings).displaced_edge_mm, 0.5);
  EXPECT_THAT(TextsOf(mesh->no_effect), testing::IsEmpty());
  const auto picture = OfEngrave({{"output_format", "png"}, {"displaced_edge", "0.5"}});
  ASSERT_TRUE(picture.ok()) << picture.status();
  EXPECT_THAT(TextsOf(picture->no_effect),
              testing::ElementsAre("displaced_edge = 0.5: needs output_format = stl or obj"));
}

}  // namespace
}  // namespace slicefarm::config::engrave::engrave_settings_test
