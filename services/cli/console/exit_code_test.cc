#include "services/cli/console/exit_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "common/base/error.h"
#include "services/cli/console/console.h"

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

}  // namespace
}  // namespace slicefarm::cli::exit_code_test
