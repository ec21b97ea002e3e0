#include "common/config/coverage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/config/projects/ini.h"
#include "tests/corpus_file.h"

namespace slicefarm::config::coverage_test {
namespace {

using ::testing::ElementsAre;
using ::testing::StartsWith;

TEST(CoverageOf, CountsKeys) {
  const std::vector<Setting> profile = {
      {"layer_height", "0.2", Source::kProfile}, {"layer_height", "0.3", Source::kProfile},
      {"printer_notes", "", Source::kProfile},   {"print_host", "here", Source::kProfile},
      {"wipe_tower", "0", Source::kProfile},     {"no_such_key", "1", Source::kProfile}};
  const Coverage coverage = CoverageOf(profile);
  EXPECT_EQ(coverage.keys, 4);
  EXPECT_EQ(coverage.effect, 2);
  EXPECT_EQ(coverage.partial, 0);
  EXPECT_EQ(coverage.none, 2);
  EXPECT_THAT(coverage.without,
              ElementsAre(StartsWith("no_such_key: unknown"), StartsWith("wipe_tower: ")));
}

TEST(CoverageOf, SumsUp) {
  EXPECT_EQ(CoverageOf({}).keys, 0);
  const auto given = ReadIni(CorpusFile("config/prusaslicer_defaults.ini"));
  ASSERT_TRUE(given.ok()) << given.status();
  const Coverage coverage = CoverageOf(*given);
  EXPECT_GT(coverage.effect, 150);
  EXPECT_EQ(coverage.keys, coverage.effect + coverage.partial + coverage.none);
  EXPECT_EQ(std::ssize(coverage.without), coverage.partial + coverage.none);
}

}  // namespace
}  // namespace slicefarm::config::coverage_test
