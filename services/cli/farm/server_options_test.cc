#include "services/cli/farm/server_options.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::cli::server_options_test {
namespace {

absl::Status ErrorOf(Reason reason) {
  return MakeError(absl::StatusCode::kInternal, reason, "message");
}

TEST(JobExitCode, IsJobFailedUnlessTheInputIsToBlame) {
  EXPECT_EQ(JobExitCode(ErrorOf(Reason::kInternal)), ExitCode::kJobFailed);
  EXPECT_EQ(JobExitCode(ErrorOf(Reason::kUnavailable)), ExitCode::kJobFailed);
  EXPECT_EQ(JobExitCode(ErrorOf(Reason::kMeshTruncated)), ExitCode::kBadMesh);
  EXPECT_EQ(JobExitCode(ErrorOf(Reason::kSettingUnknown)), ExitCode::kBadSettings);
  EXPECT_EQ(JobExitCode(ErrorOf(Reason::kCancelled)), ExitCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::cli::server_options_test
