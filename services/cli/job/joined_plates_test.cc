#include "services/cli/job/joined_plates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"
#include "common/gcode/archive/gcode_archive.h"
#include "services/cli/console/files.h"

namespace slicefarm::cli::joined_plates_test {
namespace {

TEST(OutputOf, NumbersThePlates) {
  JobOptions options;
  EXPECT_EQ(OutputOf(options, "a/b.gcode", 0), "a/b.gcode");
  options.plates = true;
  EXPECT_EQ(OutputOf(options, "a/b.x/out.gcode", 1), "a/b.x/out-2.gcode");
  EXPECT_EQ(OutputOf(options, "a.b/out.gcode.3mf", 1), "a.b/out-2.gcode.3mf");
  EXPECT_EQ(OutputOf(options, "out", 0), "out-1");
  EXPECT_EQ(OutputOf(options, "", 0), "");
}

TEST(JoinPlates, MakesOneArchive) {
  const TempDirectory folder;
  const std::string output = folder.path() + "/out.gcode.3mf";
  JobOptions options;
  options.quiet = true;
  EXPECT_TRUE(JoinPlates(options, output, 2).ok()) << "without --plates there is nothing to join";
  options.plates = true;
  for (const size_t plate : {0, 1}) {
    gcode::ArchivedPlate archived;
    archived.gcode = plate == 0 ? "G28\n" : "G29\n";
    ASSERT_TRUE(WriteFile(OutputOf(options, output, plate), *gcode::GcodeArchive({archived})).ok());
  }
  ASSERT_TRUE(JoinPlates(options, output, 2).ok());
  EXPECT_FALSE(std::filesystem::exists(OutputOf(options, output, 0)));
  const auto archive = ReadFile(output, 1 << 20);
  ASSERT_TRUE(archive.ok()) << archive.status();
  EXPECT_EQ(*gcode::TextOfPlate(*archive, 2), "G29\n");
}

TEST(JoinPlates, KeepsTheFilesIfOneIsNoArchive) {
  const TempDirectory folder;
  const std::string output = folder.path() + "/out.gcode.3mf";
  JobOptions options;
  options.plates = true;
  ASSERT_TRUE(WriteFile(OutputOf(options, output, 0), "G28\n").ok());
  EXPECT_EQ(DetailOf(JoinPlates(options, output, 1)).reason, Reason::kRequestMalformed);
  EXPECT_TRUE(std::filesystem::exists(OutputOf(options, output, 0)));
  EXPECT_FALSE(std::filesystem::exists(output));
}

}  // namespace
}  // namespace slicefarm::cli::joined_plates_test
