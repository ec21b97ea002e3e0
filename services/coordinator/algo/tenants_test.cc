#include "services/coordinator/algo/tenants.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/base/sha256.h"

namespace slicefarm::coordinator::tenants_test {
namespace {

constexpr int64_t kJan2027Us = 1'798'761'600'000'000;  // 2027-01-01T00:00:00Z

std::string Entry(const std::string& token, const std::string& scopes = R"("submit", "read")",
                  const std::string& more = "") {
  return R"({"sha256": ")" + Sha256Hex(token) + R"(", "scopes": [)" + scopes + "]" + more + "}";
}

std::string File(const std::string& tenants) { return R"({"tenants": {)" + tenants + "}}"; }

std::string FileWith(const std::string& tenant) { return File(R"("a": )" + tenant); }

Tenants Parse(const std::string& json) {
  auto tenants = ParseTenants(json);
  EXPECT_TRUE(tenants.ok()) << tenants.status();
  return tenants.value_or(Tenants());
}

TEST(Tenants, AreReadWithTheirStandards) {
  const Tenants tenants =
      Parse(File(R"("acme": {"tokens": [)" + Entry("one") + ", " +
                 Entry("two", R"("admin")", R"(, "expires": "2027-01-01T00:00:00Z")") +
                 R"(], "certificate_scopes": ["read"], "max_open_jobs": 7, "max_kept_jobs": 8,)"
                 R"( "max_kept_bytes": 5000000000, "max_calls_per_second": 100,)"
                 R"( "max_jobs_per_second": 7}, "b-2_x": {})"));
  ASSERT_EQ(tenants.size(), 2);
  const Tenant& acme = tenants.at("acme");
  ASSERT_EQ(acme.tokens.size(), 2);
  EXPECT_EQ(acme.tokens[0].scopes, (Scopes{Scope::kSubmit, Scope::kRead}));
  EXPECT_EQ(acme.tokens[0].expires_us, INT64_MAX);
  EXPECT_EQ(acme.tokens[1].scopes, Scopes{Scope::kAdmin});
  EXPECT_EQ(acme.tokens[1].expires_us, kJan2027Us);
  EXPECT_EQ(acme.certificate_scopes, Scopes{Scope::kRead});
  EXPECT_EQ(acme.max_open_jobs, 7);
  EXPECT_EQ(acme.max_kept_jobs, 8);
  EXPECT_EQ(acme.max_kept_bytes, 5'000'000'000);
  EXPECT_EQ(acme.max_calls_per_second, 100);
  EXPECT_EQ(acme.max_jobs_per_second, 7);
  const Tenant& other = tenants.at("b-2_x");
  EXPECT_TRUE(other.tokens.empty());
  EXPECT_EQ(other.certificate_scopes, (Scopes{Scope::kSubmit, Scope::kRead}));
  EXPECT_EQ(other.max_open_jobs, limits::kMaxOpenJobs);
}

TEST(Tenants, WhatCannotBeMeantIsRefusedByItsPlace) {
  struct Case {
    std::string json;
    std::string error;
  };
  for (const Case& c : {
           Case{"", "the file is not JSON"},
           Case{"[]", "the file is not an object"},
           Case{"{}", "the file has no tenants"},
           Case{R"({"tenants": {}, "version": 1})", "the file has an unknown key: version"},
           Case{R"({"tenants": []})", "tenants is not an object"},
           Case{File(R"("../a": {})"), "tenants has a name that cannot be: ../a"},
           Case{File(R"("a": {}, "a": {})"), "the file has a key twice: a"},
           Case{FileWith("1"), "tenants.a is not an object"},
           Case{FileWith(R"({"max_open_job": 1})"), "tenants.a has an unknown key: max_open_job"},
           Case{FileWith(R"({"max_open_jobs": 0})"),
                "tenants.a.max_open_jobs is not a number from 1 to 10000"},
           Case{FileWith(R"({"max_jobs_per_second": 0})"),
                "tenants.a.max_jobs_per_second is not a number from 1 to 1000000"},
           Case{FileWith(R"({"max_kept_bytes": -1})"),
                "tenants.a.max_kept_bytes is not a number from 1 to 9223372036854775807"},
           Case{FileWith(R"({"max_open_jobs": 1.5})"),
                "tenants.a.max_open_jobs is not a number from 1 to 10000"},
           Case{FileWith(R"({"tokens": {}})"), "tenants.a.tokens is not a list of at most 2"},
           Case{FileWith(R"({"tokens": [)" + Entry("1") + "," + Entry("2") + "," + Entry("3") +
                         "]}"),
                "tenants.a.tokens is not a list of at most 2"},
           Case{FileWith(R"({"tokens": [{}]})"), "tenants.a.tokens[0] has no scopes"},
           Case{FileWith(R"({"tokens": [{"sha256": "ABC", "scopes": []}]})"),
                "tenants.a.tokens[0].sha256 is not a SHA-256, 64 lower-case hex digits"},
           Case{FileWith(R"({"tokens": [)" + Entry("1", R"("write")") + "]}"),
                "tenants.a.tokens[0].scopes contains an unknown scope (scopes are submit, read, "
                "admin): \"write\""},
           Case{FileWith(R"({"tokens": [)" + Entry("1", "", R"(, "expires": "tomorrow")") + "]}"),
                "tenants.a.tokens[0].expires is not a time such as 2027-01-31T12:00:00Z"},
           Case{FileWith(R"({"tokens": [)" + Entry("1", "", R"(, "token": "sf_1")") + "]}"),
                "tenants.a.tokens[0] has an unknown key: token"},
           Case{File(R"("a": {"tokens": [)" + Entry("1") + R"(]}, "b": {"tokens": [)" + Entry("1") +
                     "]}"),
                "tenants.b.tokens[0] is in the file twice"},
           Case{FileWith(R"({"certificate_scopes": "read"})"),
                "tenants.a.certificate_scopes is not a list"},
       }) {
    const absl::Status status = ParseTenants(c.json).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << c.json;
    EXPECT_EQ(status.message(), c.error);
  }
}

TEST(Tenants, ATokenIsItsTenantsUntilItExpires) {
  const Tenants tenants =
      Parse(File(R"("a": {"max_open_jobs": 3, "tokens": [)" + Entry("one") + ", " +
                 Entry("two", R"("read")", R"(, "expires": "2027-01-01T00:00:00Z")") +
                 R"(]}, "b": {"tokens": [)" + Entry("three") + "]}"));
  const auto one = CallerWithToken(tenants, "one", kJan2027Us);
  ASSERT_TRUE(one);
  EXPECT_EQ(one->tenant, "a");
  EXPECT_EQ(one->max_open_jobs, 3);
  EXPECT_TRUE(one->may(Scope::kSubmit));
  EXPECT_FALSE(one->may(Scope::kAdmin));
  EXPECT_EQ(CallerWithToken(tenants, "two", kJan2027Us - 1)->scopes, Scopes{Scope::kRead});
  EXPECT_FALSE(CallerWithToken(tenants, "two", kJan2027Us));
  EXPECT_EQ(CallerWithToken(tenants, "three", 0)->tenant, "b");
  // The digest is not accepted as a token, so a stolen file does not give access.
  for (const std::string& token : {std::string(), std::string("four"), Sha256Hex("one")}) {
    EXPECT_FALSE(CallerWithToken(tenants, token, 0)) << token;
  }
}

TEST(Tenants, ACertificateIsItsTenants) {
  const Tenants tenants = Parse(File(R"("a": {"certificate_scopes": ["read"]})"));
  const auto caller = CallerWithCertificate(tenants, "a");
  ASSERT_TRUE(caller);
  EXPECT_EQ(caller->tenant, "a");
  EXPECT_EQ(caller->scopes, Scopes{Scope::kRead});
  EXPECT_FALSE(CallerWithCertificate(tenants, "b"));
}

TEST(Tenants, NamesMayBecomePartsOfPaths) {
  for (const char* name : {"a", "0", "acme", "a-b_c9"}) EXPECT_TRUE(IsTenantName(name)) << name;
  for (const std::string& name :
       {std::string(), std::string("-a"), std::string("_a"), std::string("A"), std::string("a/b"),
        std::string(".."), std::string("a.b"), std::string("a b"), std::string("a\0b", 3),
        std::string("ä"), std::string(64, 'a')}) {
    EXPECT_FALSE(IsTenantName(name)) << name;
  }
  EXPECT_TRUE(IsTenantName(std::string(63, 'a')));
}

TEST(Tenants, ScopesHaveNames) {
  for (const Scope scope : {Scope::kSubmit, Scope::kRead, Scope::kAdmin}) {
    EXPECT_EQ(ScopeFromName(ScopeName(scope)), scope);
  }
  EXPECT_FALSE(ScopeFromName("Submit"));
}

}  // namespace
}  // namespace slicefarm::coordinator::tenants_test
