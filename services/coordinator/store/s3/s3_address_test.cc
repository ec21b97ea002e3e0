#include "services/coordinator/store/s3/s3_address.h"

#include <gtest/gtest.h>

namespace slicefarm::coordinator::s3_address_test {
namespace {

TEST(S3Address, HasTheBucketInThePath) {
  const auto address = ParseS3Address("https://s3.example:9000/farm/prod/a/");
  ASSERT_TRUE(address.ok()) << address.status();
  EXPECT_EQ(address->endpoint, "https://s3.example:9000");
  EXPECT_EQ(address->host, "s3.example:9000");
  EXPECT_EQ(address->PathOf("blobs/x"), "/farm/prod/a/blobs/x");
  EXPECT_EQ(ParseS3Address("http://127.0.0.1:80/farm")->PathOf("x"), "/farm/x");
}

TEST(S3Address, OrInTheHostsName) {
  const auto address = ParseS3Address("https://farm.s3.example", /*bucket_in_host=*/true);
  ASSERT_TRUE(address.ok()) << address.status();
  EXPECT_EQ(address->host, "farm.s3.example");
  EXPECT_EQ(address->PathOf("x"), "/x");
  EXPECT_EQ(ParseS3Address("https://farm.s3.example/p", true)->PathOf("x"), "/p/x");
}

TEST(S3Address, IsNothingElse) {
  for (const char* url : {"", "farm", "s3://farm", "ftp://host/farm", "https://", "https://host",
                          "https://host/", "https:///farm", "https://user:word@host/farm",
                          "https://host/farm/../x", "https://host/farm//x", "https://host/a b",
                          "https://host/farm?x=y", "https://host/farm#x"}) {
    EXPECT_TRUE(absl::IsInvalidArgument(ParseS3Address(url).status())) << url;
  }
  EXPECT_FALSE(ParseS3Address("https://host/farm/" + std::string(600, 'x')).ok());
}

}  // namespace
}  // namespace slicefarm::coordinator::s3_address_test
