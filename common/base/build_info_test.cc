#include "common/base/build_info.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace slicefarm::build_info_test {
namespace {

using testing::MatchesRegex;

TEST(BuildInfo, IsFilledIn) {
  EXPECT_THAT(std::string(Version()), MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(std::string(ReleaseDate()), MatchesRegex("[0-9]{4}-[0-9]{2}-[0-9]{2}"));
  EXPECT_THAT(std::string(BuildId()), MatchesRegex("[0-9a-f]{16}"));
}

}  // namespace
}  // namespace slicefarm::build_info_test
