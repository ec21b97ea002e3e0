#include "services/coordinator/server/webhooks/webhook_policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::coordinator::webhook_policy_test {
namespace {

using testing::HasSubstr;

constexpr char kPolicy[] = R"({
  "": {"allow": ["https://Hooks.example/farm", "http://10.0.0.7:8080/"],
       "secret": "0123456789abcdef", "private": true},
  "acme": {"allow": [], "secret": "0123456789abcdef"}
})";

TEST(WebhookPolicy, LetsWhatIsOnTheList) {
  const auto policy = WebhookPolicy::Parse(kPolicy);
  ASSERT_TRUE(policy.ok()) << policy.status();
  for (const char* url :
       {"https://hooks.example/farm", "https://hooks.example/farm/a?b=c",
        "HTTPS://hooks.example:443/farm/", "http://10.0.0.7:8080", "http://10.0.0.7:8080/x"}) {
    EXPECT_TRUE(policy->Check("", url).ok()) << policy->Check("", url);
  }
  EXPECT_TRUE(policy->RulesOf("")->private_addresses);
  EXPECT_FALSE(policy->RulesOf("acme")->private_addresses);
}

TEST(WebhookPolicy, RefusesTheRest) {
  const auto policy = WebhookPolicy::Parse(kPolicy);
  for (const char* url :
       {"", "hooks.example", "http://hooks.example/farm", "https://hooks.example/",
        "https://hooks.example/farmer", "https://hooks.example/farm/../secret",
        "https://hooks.example/farm/%2e%2e/secret",
        "https://hooks.example/farm/%01/%2e%2e/%2e%2e/x", "https://hooks.example:8443/farm",
        "https://hooks.example.evil/farm", "https://hooks.example@evil/farm",
        "https://user:password@hooks.example/farm", "ftp://hooks.example/farm",
        "file:///etc/passwd", "https://hooks.example/fa rm", "https://hooks.example/farm\r\nX: y",
        "http://10.0.0.7/"}) {
    EXPECT_EQ(DetailOf(policy->Check("", url)).reason, Reason::kWebhookRefused) << url;
  }
  for (const char* tenant : {"acme", "nobody"}) {
    EXPECT_EQ(DetailOf(policy->Check(tenant, "https://hooks.example/farm")).reason,
              Reason::kWebhookRefused);
  }
  EXPECT_EQ(
      DetailOf(policy->Check("", "https://hooks.example/farm/" + std::string(3000, 'a'))).reason,
      Reason::kRequestTooLarge);
}

TEST(WebhookPolicy, NamesWhatItCannotTake) {
  const std::pair<const char*, const char*> kCases[] = {
      {"", "JSON object"},
      {R"({"a": 1})", "an object"},
      {R"({"a": {"secret": "short"}})", "16 bytes or more"},
      {R"({"a": {"secrets": ["0123456789abcdef", "short"]}})", "16 bytes or more"},
      {R"({"a": {"secrets": ["0123456789abcdef", 7]}})", "16 bytes or more"},
      {R"({"a": {"secrets": []}})", "1 to 2 secrets"},
      {R"({"a": {"secrets": ["0123456789abcdef", "0123456789abcdef", "0123456789abcdef"]}})",
       "1 to 2 secrets"},
      {R"({"a": {"secret": "0123456789abcdef", "secrets": ["0123456789abcdef"]}})", "exclude"},
      {R"({"a": {"allow": []}})", "secret: there is none"},
      {R"({"a": {"secret": "0123456789abcdef", "allow": "x"}})", "allow: a list"},
      {R"({"a": {"secret": "0123456789abcdef", "allow": ["x y"]}})", "not an http(s) URL"},
      {R"({"a": {"secret": "0123456789abcdef", "alow": []}})", "alow: is unknown"},
      {R"({"a": {"secret": "0123456789abcdef", "private": 1}})", "private: is unknown"},
  };
  for (const auto& [text, said] : kCases) {
    EXPECT_THAT(std::string(WebhookPolicy::Parse(text).status().message()), HasSubstr(said))
        << text;
  }
}

}  // namespace
}  // namespace slicefarm::coordinator::webhook_policy_test
