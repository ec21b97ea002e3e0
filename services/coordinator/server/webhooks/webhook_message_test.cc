#include "services/coordinator/server/webhooks/webhook_message.h"

#include <gtest/gtest.h>

#include "nlohmann/json.hpp"

namespace slicefarm::coordinator::webhook_message_test {
namespace {

// printf '1700000000.{"a":1}' | openssl dgst -sha256 -hmac 0123456789abcdef
TEST(WebhookSignature, IsTheHmacThatOthersCompute) {
  EXPECT_EQ(WebhookSignature("0123456789abcdef", 1'700'000'000, R"({"a":1})"),
            "t=1700000000,v1=9eb18f493f8ec135d9eb2dad817c369bb4e9cbfa818657897a7437c1cd8c3a23");
}

TEST(WebhookBody, TellsOfTheJobWithoutItsSettings) {
  JobRecord job;
  job.id = "abc";
  job.state = JobState::kFailed;
  job.labels = {{"order", "a \"quoted\"\nname"}};
  job.error = JobError{absl::StatusCode::kInvalidArgument, "MESH_EMPTY", "no triangle", {}};
  const auto json = nlohmann::json::parse(WebhookBody(job));
  EXPECT_EQ(json["type"], "job.ended");
  EXPECT_EQ(json["job"]["id"], "abc");
  EXPECT_EQ(json["job"]["state"], "JOB_STATE_FAILED");
  EXPECT_EQ(json["job"]["labels"]["order"], "a \"quoted\"\nname");
  EXPECT_EQ(json["job"]["error"]["reason"], "MESH_EMPTY");
}

}  // namespace
}  // namespace slicefarm::coordinator::webhook_message_test
