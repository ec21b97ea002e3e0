#include "services/coordinator/server/api/audit_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "common/base/sha256.h"
#include "services/coordinator/server/api/coordinator_client_test.h"
#include "services/coordinator/server/api/served_coordinator_test.h"

namespace slicefarm::coordinator::audit_log_test {
namespace {

class AuditLogTest : public ServedCoordinatorTest {
 protected:
  AuditLogTest() {
    auto tenants = std::make_shared<Tenants>();
    (*tenants)["a"].tokens = {{Sha256Hex("secret"), {Scope::kSubmit, Scope::kRead}}};
    (*tenants)["ops"].tokens = {{Sha256Hex("admin"), {Scope::kAdmin}}};
    CoordinatorOptions options = Options();
    options.tenants = [tenants] { return tenants; };
    server_options_.interceptors.push_back(
        [this] { return std::make_unique<AuditLogFactory>(coordinator_->callers(), log_); });
    Serve(options);
  }

  CoordinatorClient As(const std::string& token) {
    rpc::ChannelOptions options;
    options.token = token;
    CoordinatorClient client;
    client.Connect(address(), options);
    return client;
  }

  std::vector<nlohmann::json> Lines() {
    std::vector<nlohmann::json> lines;
    std::istringstream text(text_.str());
    for (std::string line; std::getline(text, line);) lines.push_back(nlohmann::json::parse(line));
    return lines;
  }

  std::ostringstream text_;
  rpc::JsonLog log_{"test", std::make_shared<spdlog::logger>(
                                "audit", std::make_shared<spdlog::sinks::ostream_sink_mt>(text_))};
};

TEST_F(AuditLogTest, SaysWhoDidWhat) {
  CoordinatorClient a = As("secret");
  const std::string id = a.Submit("xx");
  a.AwaitEnd(id);
  const std::string token = Sha256Hex("secret").substr(0, 12);
  const auto lines = Lines();
  ASSERT_EQ(lines.size(), 2U) << text_.str();
  for (const nlohmann::json& line : lines) {
    EXPECT_EQ(line["msg"], "audit");
    EXPECT_EQ(line["tenant"], "a");
    EXPECT_EQ(line["token"], token);
    EXPECT_EQ(line["code"], "OK");
    EXPECT_THAT(line["address"].get<std::string>(), testing::StartsWith("ipv4:127.0.0.1:"));
  }
  EXPECT_EQ(lines[0]["method"], "/slicefarm.v1.Meshes/UploadMesh");
  EXPECT_EQ(lines[0]["objects"], Sha256Hex("xx"));
  EXPECT_EQ(lines[1]["method"], "/slicefarm.v1.Jobs/CreateJob");
  EXPECT_THAT(lines[1]["objects"].get<std::string>(), testing::HasSubstr(id));
  EXPECT_THAT(text_.str(), testing::Not(testing::HasSubstr("secret")));
}

TEST_F(AuditLogTest, AnAdministratorsCancelIsNoTenants) {
  CoordinatorClient a = As("secret");
  const std::string id = a.Submit("xx");
  a.AwaitEnd(id);
  const size_t before = Lines().size();
  CoordinatorClient ops = As("admin");
  v1::CancelJobRequest request;
  request.set_id(id);
  grpc::ClientContext context;
  v1::Job job;
  ASSERT_TRUE(ops.jobs_->CancelJob(&context, request, &job).ok());
  const auto lines = Lines();
  ASSERT_EQ(lines.size(), before + 1) << text_.str();
  EXPECT_EQ(lines.back()["tenant"], "ops");
  EXPECT_EQ(lines.back()["objects"], id + " a") << "the job, and whose it is";
}

TEST_F(AuditLogTest, WhatWasRefusedIsThereToo) {
  CoordinatorClient nobody = As("guessed");
  EXPECT_FALSE(nobody.Create(CoordinatorClient::RequestFor("xx")).ok());
  const auto lines = Lines();
  ASSERT_EQ(lines.size(), 1U) << text_.str();
  EXPECT_EQ(lines[0]["code"], "UNAUTHENTICATED");
  EXPECT_EQ(lines[0]["reason"], "UNAUTHENTICATED");
  EXPECT_FALSE(lines[0].contains("tenant"));
}

TEST_F(AuditLogTest, ReadingIsNotWritten) {
  CoordinatorClient a = As("secret");
  a.List();
  EXPECT_EQ(text_.str(), "");
}

}  // namespace
}  // namespace slicefarm::coordinator::audit_log_test
