#include "services/slicing/algo/mesh_io/threemf/settings/height_profiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::slicing::threemf::height_profiles_test {
namespace {

using testing::Pair;
using testing::UnorderedElementsAre;

TEST(HeightProfiles, HaveALineForEachObject) {
  const auto profiles = ReadHeightProfiles(
      "object_id=1|0.000000;0.200000;10.000000;0.100000\r\nobject_id=3|0;0.3\n\nobject_id=4|\n",
      "p");
  ASSERT_TRUE(profiles.ok()) << profiles.status();
  EXPECT_THAT(*profiles, UnorderedElementsAre(Pair(1, "0;0.2;10;0.1"), Pair(3, "0;0.3")));
  EXPECT_TRUE(ReadHeightProfiles("", "p")->empty());
}

TEST(HeightProfiles, RefusesWhatIsNone) {
  for (const std::string_view line :
       {"object_id=1", "object=1|0;0.2", "object_id=0|0;0.2", "object_id=x|0;0.2",
        "object_id=1|0;0.2;1", "object_id=1|0;9"}) {
    const auto profiles = ReadHeightProfiles("object_id=7|0;0.2\n" + std::string(line), "p");
    ASSERT_FALSE(profiles.ok()) << line;
    EXPECT_EQ(DetailOf(profiles.status()).reason, Reason::kMeshMalformed) << line;
    EXPECT_EQ(DetailOf(profiles.status()).metadata["line"], "2") << line;
  }
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::height_profiles_test
