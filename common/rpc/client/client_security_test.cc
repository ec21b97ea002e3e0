#include "common/rpc/client/client_security.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "common/base/error.h"
#include "common/rpc/security/dev_certs_test.h"

namespace slicefarm::rpc::client_security_test {
namespace {

constexpr char kHere[] = "127.0.0.1:50050";
constexpr char kElsewhere[] = "farm.example:50050";

class ClientSecurityTest : public testing::Test {
 protected:
  void SetUp() override { unsetenv("SLICEFARM_TOKEN"); }
  void TearDown() override { unsetenv("SLICEFARM_TOKEN"); }

  std::string TokenFile(const std::string& text) {
    const std::string path = directory_.path() + "/token";
    std::ofstream(path) << text;
    return path;
  }

  TempDirectory directory_;
  ClientSecurity security_ = {.with_token = true};
};

TEST_F(ClientSecurityTest, WithoutAnythingAChannelIsAsItWas) {
  const auto options = Secured({.retries = false}, security_, kElsewhere);
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_FALSE(options->retries);
  EXPECT_EQ(options->credentials, nullptr);
  EXPECT_EQ(options->token, "");
}

TEST_F(ClientSecurityTest, TheTokenIsThatOfTheFileOrElseOfTheEnvironment) {
  setenv("SLICEFARM_TOKEN", "sf_2", 1);
  EXPECT_EQ(Secured({}, security_, kHere)->token, "sf_2");
  security_.token_file = TokenFile("sf_1\n");
  EXPECT_EQ(Secured({}, security_, kHere)->token, "sf_1");
  security_.with_token = false;
  EXPECT_EQ(Secured({}, security_, kElsewhere)->token, "");
}

TEST_F(ClientSecurityTest, ATokenDoesNotLeaveTheMachineInPlainText) {
  security_.token_file = TokenFile("sf_1");
  const absl::Status status = Secured({}, security_, kElsewhere).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("plain text"));
  DevCerts certs;
  security_.tls.ca = certs.Make("coordinator").ca;
  const auto options = Secured({}, security_, kElsewhere);
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_NE(options->credentials, nullptr);
}

TEST_F(ClientSecurityTest, WhatIsNoTokenIsRefusedAndNotShown) {
  for (const char* text : {"", "\n", "two words", "bad\x01"}) {
    security_.token_file = TokenFile(text);
    const absl::Status status = Secured({}, security_, kHere).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << text;
    EXPECT_THAT(std::string(status.message()), testing::Not(testing::HasSubstr("words")));
  }
  security_.token_file = directory_.path() + "/none";
  EXPECT_EQ(DetailOf(Secured({}, security_, kHere).status()).metadata["file"],
            security_.token_file);
}

TEST_F(ClientSecurityTest, HintsFitTheFilesAtHand) {
  const absl::Status closed = absl::UnavailableError("last error: Socket closed");
  EXPECT_THAT(ConnectionHint(closed, security_), testing::HasSubstr("--tls-ca"));
  security_.tls.ca = "ca.pem";
  EXPECT_THAT(ConnectionHint(closed, security_), testing::HasSubstr("--tls-cert"));
  security_.tls.cert = "cert.pem";
  EXPECT_THAT(ConnectionHint(closed, security_), testing::HasSubstr("cert.pem"));
  EXPECT_EQ(ConnectionHint(absl::UnavailableError("Connection refused"), security_),
            ": nothing listens at this address");
  for (const char* words : {"Failed parsing HTTP/2", "Trying to connect an http1.x server"})
    EXPECT_THAT(ConnectionHint(absl::UnavailableError(words), security_),
                testing::HasSubstr("not a gRPC server"));
  EXPECT_EQ(ConnectionHint(absl::InternalError("Socket closed"), security_), "");
}

}  // namespace
}  // namespace slicefarm::rpc::client_security_test
