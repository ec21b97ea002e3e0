#include "services/coordinator/server/main/s3_flags.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace slicefarm::coordinator::s3_flags_test {
namespace {

TEST(S3Credentials, AreReadFromAFile) {
  const auto read = ParseS3Credentials(R"({"access_key": "A", "secret_key": "s"})");
  ASSERT_TRUE(read.ok()) << read.status();
  EXPECT_EQ(read->access_key, "A");
  EXPECT_EQ(read->secret_key, "s");
  EXPECT_EQ(read->session_token, "");
  const auto token = R"({"access_key": "A", "secret_key": "s", "session_token": "t"})";
  EXPECT_EQ(ParseS3Credentials(token)->session_token, "t");
}

TEST(S3Credentials, AreBothThereAndNothingElseIs) {
  for (const char* text : {"", "[]", "{}", R"({"access_key": "A"})", R"({"secret_key": "s"})",
                           R"({"access_key": "A", "secret_key": 5})",
                           R"({"access_key": "A", "secret_key": "s", "region": "x"})"}) {
    EXPECT_TRUE(absl::IsInvalidArgument(ParseS3Credentials(text).status())) << text;
  }
}

TEST(S3Credentials, OrOfTheEnvironment) {
  unsetenv("AWS_ACCESS_KEY_ID");
  EXPECT_TRUE(absl::IsInvalidArgument(S3CredentialsOfEnvironment().status()));
  setenv("AWS_ACCESS_KEY_ID", "A", 1);
  setenv("AWS_SECRET_ACCESS_KEY", "s", 1);
  EXPECT_EQ(S3CredentialsOfEnvironment()->secret_key, "s");
  unsetenv("AWS_ACCESS_KEY_ID");
  unsetenv("AWS_SECRET_ACCESS_KEY");
}

}  // namespace
}  // namespace slicefarm::coordinator::s3_flags_test
