#include "services/cli/exit_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "common/base/error.h"
#include "services/cli/console.h"
#include "services/cli/server_options.h"
#include "services/cli/summary.h"

namespace slicefarm::cli::exit_code_test {
namespace {

using testing::HasSubstr;

absl::Status ErrorOf(Reason reason) {
  return MakeError(absl::StatusCode::kInternal, reason, "message");
}

TEST(ExitCodeOf, TellsScriptsWhatKindOfErrorItIs) {
  EXPECT_EQ(ExitCodeOf(absl::OkStatus()), ExitCode::kOk);
  const std::pair<Reason, ExitCode> kCases[] = {
      {Reason::kInternal, ExitCode::kInternal},
      {Reason::kRequestMalformed, ExitCode::kUsage},
      {Reason::kSettingUnknown, ExitCode::kBadSettings},
      {Reason::kSettingOutOfRange, ExitCode::kBadSettings},
      {Reason::kSettingMisplaced, ExitCode::kBadSettings},
      {Reason::kNotSupported, ExitCode::kBadSettings},
      {Reason::kPrinterMissing, ExitCode::kBadSettings},
      {Reason::kMeshTruncated, ExitCode::kBadMesh},
      {Reason::kMeshTooExpensive, ExitCode::kBadMesh},
      {Reason::kMeshReaderCrashed, ExitCode::kBadMesh},
      {Reason::kMeshReaderKilled, ExitCode::kServerUnavailable},
      {Reason::kOutOfBuildVolume, ExitCode::kBadMesh},
      {Reason::kNothingToPrint, ExitCode::kBadMesh},
      {Reason::kUnavailable, ExitCode::kServerUnavailable},
      {Reason::kDeadlineExceeded, ExitCode::kServerUnavailable},
      {Reason::kBlobDigestMismatch, ExitCode::kJobFailed},
      {Reason::kRangePoisoned, ExitCode::kJobFailed},
      {Reason::kJobPoisoned, ExitCode::kJobFailed},
      {Reason::kCancelled, ExitCode::kCancelled},
      {Reason::kJobNotFound, ExitCode::kNotFound},
  };
  for (const auto& [reason, code] : kCases) {
    EXPECT_EQ(ExitCodeOf(ErrorOf(reason)), code) << ReasonName(reason);
  }
  EXPECT_EQ(ExitCodeOf(MakeError(absl::StatusCode::kUnavailable, Reason::kStoreFailed, "away")),
            ExitCode::kServerUnavailable);
  EXPECT_EQ(ExitCodeOf(absl::DataLossError("cannot write")), ExitCode::kOutputFailed);
  const absl::Status spoilt =
      MakeError(absl::StatusCode::kDataLoss, Reason::kBlobDigestMismatch, "of the download");
  EXPECT_EQ(ExitCodeOf(spoilt), ExitCode::kJobFailed);
}

TEST(JobExitCode, IsJobFailedUnlessTheInputIsToBlame) {
  EXPECT_EQ(JobExitCode(ErrorOf(Reason::kInternal)), ExitCode::kJobFailed);
  EXPECT_EQ(JobExitCode(ErrorOf(Reason::kUnavailable)), ExitCode::kJobFailed);
  EXPECT_EQ(JobExitCode(ErrorOf(Reason::kMeshTruncated)), ExitCode::kBadMesh);
  EXPECT_EQ(JobExitCode(ErrorOf(Reason::kSettingUnknown)), ExitCode::kBadSettings);
  EXPECT_EQ(JobExitCode(ErrorOf(Reason::kCancelled)), ExitCode::kCancelled);
}

TEST(Advice, SaysWhatToDo) {
  EXPECT_NE(Advice(ErrorOf(Reason::kSettingUnknown)), "");
  EXPECT_NE(Advice(ErrorOf(Reason::kOutOfBuildVolume)), "");
  EXPECT_EQ(Advice(absl::DataLossError("cannot write")), "");
}

TEST(Advice, FitsTheError) {
  const auto advice = [](Reason reason, std::map<std::string, std::string> metadata) {
    return Advice(
        MakeError(absl::StatusCode::kInvalidArgument, reason, "wrong", std::move(metadata)));
  };
  EXPECT_THAT(advice(Reason::kSettingOutOfRange, {{"setting", "skirts"}}),
              HasSubstr("--set skirts=VALUE"));
  EXPECT_THAT(advice(Reason::kSettingOutOfRange, {{"setting", "cutter"}}),
              HasSubstr("`slicefarm settings cutter --machine mill`"));
  EXPECT_THAT(
      advice(Reason::kNotSupported,
             {{"feature", "several_tools"}, {"allow", "several_tools"}, {"setting", "extruder"}}),
      testing::AllOf(HasSubstr("the same extruder"), HasSubstr("--allow several_tools")));
  EXPECT_THAT(advice(Reason::kNotSupported,
                     {{"feature", "seam_position=random"}, {"setting", "seam_position"}}),
              HasSubstr("--set seam_position=VALUE"));
  EXPECT_THAT(advice(Reason::kPrinterMissing, {}), HasSubstr("--generic"));
  EXPECT_EQ(advice(Reason::kSettingMalformed, {}), "");
  EXPECT_THAT(advice(Reason::kRequestMalformed, {{"field", "plate"}, {"plates", "2"}}),
              HasSubstr("--plate N"));
  EXPECT_EQ(advice(Reason::kRequestMalformed, {{"field", "copies"}}), "");
  EXPECT_THAT(advice(Reason::kDeadlineExceeded, {}), HasSubstr("network"));
  EXPECT_THAT(advice(Reason::kDeadlineExceeded, {{"field", "deadline"}}), HasSubstr("--deadline"));
}

TEST(SummaryText, SaysWhatMatters) {
  EXPECT_EQ(SummaryText({.output = "a.gcode",
                         .layers = 240,
                         .print_time_s = 3957,
                         .filament_mm = 4530,
                         .filament_g = 13.51}),
            "a.gcode: 240 layers, 1h 5m 57s to print, 4.53 m of filament (13.5 g)\n");
  EXPECT_EQ(SummaryText({.layers = 1,
                         .print_time_s = 5,
                         .filament_mm = 10,
                         .cached = true,
                         .settings_without_effect = 3}),
            "1 layer, 5s to print, 0.01 m of filament; found by content, not made anew\n"
            "3 of the given settings have no effect; --report FILE.json lists them\n");
  EXPECT_EQ(SummaryText({.layers = 1, .settings_without_effect = 54, .beside_print = 52}),
            "1 layer, 0s to print\n"
            "2 of the given settings have no effect (52 others do not matter to this print); "
            "--report FILE.json lists them\n");
  EXPECT_EQ(SummaryText({.layers = 1,
                         .settings_without_effect = 7,
                         .changing = {"a = 1: not yet", "b = 2: x", "c = 3: y", "d = 4: z"},
                         .beside_print = 2}),
            "1 layer, 0s to print\n"
            "5 of the given settings have no effect, first of all a = 1, b = 2, c = 3 and 1 more, "
            "which change the print (2 others do not matter to this print); --report FILE.json "
            "lists them\n");
  EXPECT_EQ(SummaryText({.layers = 1, .job = "0123"}), "1 layer, 0s to print; job 0123\n");
  EXPECT_EQ(SummaryText({.layers = 1, .settings_without_effect = 52, .beside_print = 52}),
            "1 layer, 0s to print\n");
  EXPECT_EQ(SummaryText({.words = {"step", "steps", "to mill"}, .layers = 3, .print_time_s = 60}),
            "3 steps, 1m 0s to mill\n");
  EXPECT_EQ(
      SummaryText({.output = "a", .layers = 2, .settings_without_effect = 1, .report = "r.json"}),
      "a: 2 layers, 0s to print\n"
      "1 of the given settings has no effect; listed in r.json\n");
}

}  // namespace
}  // namespace slicefarm::cli::exit_code_test
