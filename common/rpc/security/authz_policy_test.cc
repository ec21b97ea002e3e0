#include "common/rpc/security/authz_policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/rpc/security/authorizer.h"

namespace slicefarm::rpc::authz_policy_test {
namespace {

AuthzPolicy Parse(const std::string& json) {
  auto policy = AuthzPolicy::Parse(json);
  EXPECT_TRUE(policy.ok()) << policy.status();
  return policy.value_or(AuthzPolicy());
}

/// Returns a policy with one allow rule.
AuthzPolicy Allowing(const std::string& rule) {
  return Parse(R"({"allow_rules": [)" + rule + "]}");
}

TEST(AuthzPolicy, WhatNoRuleAllowsIsDenied) {
  EXPECT_FALSE(Parse(R"({"allow_rules": []})").Allows("a", "/s/M"));
  EXPECT_FALSE(AuthzPolicy().Allows("a", "/s/M"));
}

TEST(AuthzPolicy, PatternsAreWholeTextsPrefixesSuffixesOrAnything) {
  const auto allows = [](const std::string& pattern, const std::string& text) {
    return Allowing(R"({"source": {"principals": [")" + pattern + R"("]}})").Allows(text, "/s/M");
  };
  EXPECT_TRUE(allows("abc", "abc"));
  EXPECT_FALSE(allows("abc", "abcd"));
  EXPECT_TRUE(allows("ab*", "abc"));
  EXPECT_FALSE(allows("ab*", "a"));
  EXPECT_TRUE(allows("*bc", "abc"));
  EXPECT_FALSE(allows("*bc", "abcd"));
  EXPECT_TRUE(allows("*", "abc"));
  EXPECT_FALSE(allows("*", ""));
  EXPECT_TRUE(allows("", ""));
  EXPECT_FALSE(allows("", "abc"));
}

TEST(AuthzPolicy, ARuleFitsByPrincipalAndPath) {
  const AuthzPolicy policy =
      Allowing(R"({"source": {"principals": ["a", "b"]}, "request": {"paths": ["/s/M", "/t/*"]}})");
  EXPECT_TRUE(policy.Allows("a", "/s/M"));
  EXPECT_TRUE(policy.Allows("b", "/t/N"));
  EXPECT_FALSE(policy.Allows("c", "/s/M"));
  EXPECT_FALSE(policy.Allows("a", "/s/N"));
}

TEST(AuthzPolicy, WhatARuleDoesNotNameFitsAnything) {
  EXPECT_TRUE(Allowing("{}").Allows("", "/s/M"));
  EXPECT_TRUE(Allowing(R"({"source": {}, "request": {"paths": ["/s/M"]}})").Allows("", "/s/M"));
}

TEST(AuthzPolicy, ADenyRuleGoesFirst) {
  const AuthzPolicy policy = Parse(
      R"({"deny_rules": [{"source": {"principals": ["a"]}}], "allow_rules": [{"name": "all"}]})");
  EXPECT_FALSE(policy.Allows("a", "/s/M"));
  EXPECT_TRUE(policy.Allows("b", "/s/M"));
}

TEST(AuthzPolicy, WhatCannotBeMeantIsRefused) {
  struct Case {
    std::string json;
    std::string error;
  };
  for (const Case& c : {
           Case{"", "the policy is not an object"},
           Case{"{}", "the policy has no allow_rules"},
           Case{R"({"allow_rules": {}})", "allow_rules is not a list"},
           Case{R"({"allow_rules": [], "audit": 1})", "the policy has an unknown key: audit"},
           Case{R"({"allow_rules": [{}, 1]})", "allow_rules[1] is not an object"},
           Case{R"({"allow_rules": [{"request": {"headers": []}}]})",
                "allow_rules[0].request has an unknown key: headers"},
           Case{R"({"allow_rules": [{"source": {"principals": []}}]})",
                "allow_rules[0].source.principals is not a list of patterns"},
           Case{R"({"allow_rules": [], "deny_rules": [{"request": {"paths": [1]}}]})",
                "deny_rules[0].request.paths is not a list of patterns"},
           Case{R"({"allow_rules": [{"name": 1}]})", "allow_rules[0] has a name that is no text"},
       }) {
    const absl::Status status = AuthzPolicy::Parse(c.json).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
    EXPECT_EQ(status.message(), "authorization policy: " + c.error);
  }
}

TEST(AuthzPolicy, BetweenServicesTheMethodsAreTheCoordinators) {
  const AuthzPolicy policy = Parse(std::string(InnerPolicy()));
  for (const char* path : {"/slicefarm.v1.Beading/BeadLayers", "/slicefarm.v1.Worker/WorkRange"}) {
    EXPECT_TRUE(policy.Allows("spiffe://slicefarm/coordinator", path));
    EXPECT_FALSE(policy.Allows("spiffe://slicefarm/worker", path));
    EXPECT_FALSE(policy.Allows("spiffe://slicefarm/tenant/coordinator", path));
    EXPECT_FALSE(policy.Allows("", path));
  }
  EXPECT_TRUE(policy.Allows("spiffe://slicefarm/worker", "/grpc.health.v1.Health/Check"));
  EXPECT_FALSE(policy.Allows("", "/grpc.health.v1.Health/Check"));
  EXPECT_FALSE(policy.Allows("spiffe://slicefarm/coordinator", "/elsewhere.S/M"));
}

}  // namespace
}  // namespace slicefarm::rpc::authz_policy_test
