#include "services/coordinator/store/s3/sigv4.h"

#include <gtest/gtest.h>

#include "common/base/sha256.h"

namespace slicefarm::coordinator::sigv4_test {
namespace {

// The examples of the Amazon S3 API reference, "Signature Calculations for the Authorization
// Header".
const S3Credentials kCredentials = {"AKIAIOSFODNN7EXAMPLE",
                                    "wJalrXUtnFEMI/K7MDENG/bPxRfiCYEXAMPLEKEY"};
constexpr const char* kTime = "20130524T000000Z";
const std::string kNothing = Sha256Hex("");

struct Case {
  std::string name;
  S3Request request;
  std::string signature;
};

S3Request Request(const std::string& method, const std::string& path,
                  std::vector<std::pair<std::string, std::string>> query,
                  std::vector<std::pair<std::string, std::string>> headers,
                  const std::string& payload_sha256) {
  headers.emplace_back("host", "examplebucket.s3.amazonaws.com");
  headers.emplace_back("x-amz-content-sha256", payload_sha256);
  headers.emplace_back("x-amz-date", kTime);
  return {method, path, std::move(query), std::move(headers), payload_sha256};
}

class S3AuthorizationTest : public testing::TestWithParam<Case> {};

TEST_P(S3AuthorizationTest, IsWhatTheReferenceSays) {
  const std::string header = S3Authorization(GetParam().request, kCredentials, "us-east-1", kTime);
  EXPECT_TRUE(header.starts_with(
      "AWS4-HMAC-SHA256 Credential=AKIAIOSFODNN7EXAMPLE/20130524/us-east-1/s3/aws4_request,"))
      << header;
  EXPECT_EQ(header.substr(header.find("Signature=") + 10), GetParam().signature);
}

const std::string kWelcome = Sha256Hex("Welcome to Amazon S3.");

INSTANTIATE_TEST_SUITE_P(
    Reference, S3AuthorizationTest,
    testing::Values(
        Case{"GetAnObject", Request("GET", "/test.txt", {}, {{"range", "bytes=0-9"}}, kNothing),
             "f0e8bdb87c964420e857bd35b5d6ed310bd44f0170aba48dd91039c6036bdb41"},
        Case{"PutAnObject",
             Request("PUT", UriEncoded("/test$file.text", true), {},
                     {{"date", "Fri, 24 May 2013 00:00:00 GMT"},
                      {"x-amz-storage-class", "REDUCED_REDUNDANCY"}},
                     kWelcome),
             "98ad721746da40c64f1a55b78f14c238d841ea1380cd77a1b5971af0ece108bd"},
        Case{"AQueryWithoutAValue", Request("GET", "/", {{"lifecycle", ""}}, {}, kNothing),
             "fea454ca298b7da1c68078a5d1bdbfbbe0d65c699e0f91ac7a200a0136783543"},
        Case{"ListObjects", Request("GET", "/", {{"prefix", "J"}, {"max-keys", "2"}}, {}, kNothing),
             "34b48302e7b5fa45bde8084f4b7868a86f0a534bc59db6670ed5711ef69dc6f7"}),
    [](const auto& info) { return info.param.name; });

TEST(UriEncoded, LeavesWhatNeedsNoEncoding) {
  EXPECT_EQ(UriEncoded("aZ09-_.~", false), "aZ09-_.~");
  EXPECT_EQ(UriEncoded("a/b c*+\xc3\xa4", true), "a/b%20c%2A%2B%C3%A4");
  EXPECT_EQ(UriEncoded("a/b", false), "a%2Fb");
}

}  // namespace
}  // namespace slicefarm::coordinator::sigv4_test
