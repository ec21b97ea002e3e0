#include "services/coordinator/server/webhooks/webhook_message.h"

#include <gtest/gtest.h>

#include "nlohmann/json.hpp"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator::webhook_message_test {
namespace {

// Expected value from: printf '1700000000.{"a":1}' | openssl dgst -sha256 -hmac 0123456789abcdef
TEST(WebhookSignature, IsTheHmacThatOthersCompute) {
  EXPECT_EQ(WebhookSignature({"0123456789abcdef"}, 1'700'000'000, R"({"a":1})"),
            "t=1700000000,v1=9eb18f493f8ec135d9eb2dad817c369bb4e9cbfa818657897a7437c1cd8c3a23");
}

// While a secret is being replaced, receivers with the old secret and with the new one accept the
// message.
TEST(WebhookSignature, HasOneOfEachSecret) {
  const std::string first = WebhookSignature({"the first secret"}, 5, "body");
  const std::string second = WebhookSignature({"the second secret"}, 5, "body");
  EXPECT_EQ(WebhookSignature({"the first secret", "the second secret"}, 5, "body"),
            first + second.substr(second.find(",v1=")));
}

/// Returns a spec with settings at every level that can have settings.
v1::JobSpec SpecWithSettings() {
  v1::JobSpec spec;
  const auto tell = [](v1::Setting& setting) {
    setting.set_key("start_gcode");
    setting.set_value("of our customer");
  };
  tell(*spec.add_settings());
  tell(*spec.add_project_settings());
  *spec.add_without_effect() = "of our customer, too";
  v1::Object& object = *spec.add_objects();
  object.set_mesh_sha256(std::string(64, 'a'));
  tell(*object.add_settings());
  tell(*object.add_parts()->add_settings());
  tell(*object.add_height_ranges()->add_settings());
  return spec;
}

TEST(WebhookBody, TellsNoSettingsOfAnyPlace) {
  JobRecord job;
  job.id = "abc";
  job.spec = SpecWithSettings().SerializeAsString();
  const std::string body = WebhookBody(job);
  EXPECT_EQ(body.find("of our customer"), std::string::npos) << body;
  EXPECT_EQ(nlohmann::json::parse(body)["job"]["spec"]["objects"][0]["mesh_sha256"],
            std::string(64, 'a'));
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
