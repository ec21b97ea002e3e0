#include "services/cli/job/job_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"
#include "services/cli/console/files.h"

namespace slicefarm::cli::job_options_test {
namespace {

using config::Setting;
using config::Source;
using testing::ElementsAre;
using testing::HasSubstr;

std::string TempFile(const std::string& name, const std::string& text) {
  const std::string path = testing::TempDir() + "/job_options_" + name;
  EXPECT_TRUE(WriteFile(path, text).ok());
  return path;
}

TEST(GivenSettings, PutsFilesBeforeHand) {
  JobOptions options;
  options.config_files = {TempFile("a.ini", "perimeters = 2\n"),
                          TempFile("b.ini", "perimeters = 3\n")};
  options.sets = {"perimeters=4", " start_gcode = G28 ; a=b"};
  const auto settings = GivenSettings(options);
  ASSERT_TRUE(settings.ok()) << settings.status();
  EXPECT_THAT(*settings, ElementsAre(Setting{"perimeters", "2", Source::kProfile},
                                     Setting{"perimeters", "3", Source::kProfile},
                                     Setting{"perimeters", "4", Source::kRequest},
                                     Setting{"start_gcode", " G28 ; a=b", Source::kRequest}));
}

TEST(GivenSettings, NamesTheFileThatIsWrong) {
  JobOptions options;
  options.config_files = {TempFile("bundle.ini", "[print:x]\n")};
  const auto settings = GivenSettings(options);
  ASSERT_FALSE(settings.ok());
  EXPECT_EQ(DetailOf(settings.status()).reason, Reason::kSettingMalformed);
  EXPECT_THAT(std::string(settings.status().message()), HasSubstr("bundle.ini: line 1"));
  options.config_files = {"/does/not/exist.ini"};
  EXPECT_EQ(DetailOf(GivenSettings(options).status()).reason, Reason::kRequestMalformed);
}

TEST(GivenSettings, WantsAnEqualsSign) {
  for (const char* text : {"perimeters", "=3", ""}) {
    JobOptions options;
    options.sets = {text};
    EXPECT_EQ(DetailOf(GivenSettings(options).status()).reason, Reason::kRequestMalformed) << text;
  }
}

TEST(GivenSettings, AreUtf8) {
  JobOptions options;
  options.sets = {"start_gcode=; M\xfcller"};
  const auto settings = GivenSettings(options);
  EXPECT_EQ(DetailOf(settings.status()).reason, Reason::kSettingMalformed);
  EXPECT_EQ(DetailOf(settings.status()).metadata["setting"], "start_gcode");
}

TEST(WithCreationTime, OnlyWhereGcodeMayNameIt) {
  const auto first = [](const char* key, const char* value) {
    return WithCreationTime({{key, value, config::Source::kProfile}}).front().key;
  };
  EXPECT_EQ(first("start_gcode", "; made [timestamp]"), "creation_time");
  EXPECT_EQ(first("start_gcode", "{if hour > 12}M300{endif}"), "creation_time");
  EXPECT_EQ(first("start_gcode", "G28"), "start_gcode");
  EXPECT_EQ(first("output_filename_format", "part_{timestamp}.gcode"), "creation_time");
  EXPECT_EQ(first("notes", "timestamp"), "notes");
  EXPECT_EQ(WithCreationTime({}, true).size(), 1u);
}

TEST(GivenJobSettings, NamesOfLasersFilesAreForLasers) {
  JobOptions options;
  for (const std::string suffix : {"cli", "svg", "dxf"}) {
    options.process = Process::kFdm;
    const auto fdm = GivenJobSettings(options, "part." + suffix);
    EXPECT_EQ(DetailOf(fdm.status()).reason, Reason::kRequestMalformed);
    EXPECT_THAT(std::string(fdm.status().message()), HasSubstr("--machine laser"));
    options.process = Process::kLaser;
    EXPECT_THAT(*GivenJobSettings(options, "part." + suffix),
                ElementsAre(Setting{"output_format", suffix, Source::kRequest}));
  }
  options.process = Process::kFdm;
  EXPECT_TRUE(GivenJobSettings(options, "part.nc").ok());
}

TEST(GivenJobSettings, ProcessesMayShareAName) {
  JobOptions options;
  options.process = Process::kMill;
  EXPECT_THAT(*GivenJobSettings(options, "level.svg"),
              ElementsAre(Setting{"output_format", "svg", Source::kRequest}));
  EXPECT_FALSE(GivenJobSettings(options, "part.dxf").ok());
}

}  // namespace
}  // namespace slicefarm::cli::job_options_test
