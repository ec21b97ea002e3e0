#include "services/coordinator/store/s3/s3_address.h"

#include <gtest/gtest.h>

namespace slicefarm::coordinator::s3_address_test {
namespace {

TEST(S3Address, HasTheBucketInThePath) {
  const auto address = ParseS3Address("https://s3.example:9000/farm/prod/a/");
  ASSERT_TRUE(address.ok()) << address.status();
  EXPECT_EQ(address->UrlOf("blobs/x"), "https://s3.example:9000/farm/prod/a/blobs/x");
  EXPECT_EQ(ParseS3Address("http://127.0.0.1:80/farm")->UrlOf("x"), "http://127.0.0.1:80/farm/x");
}

TEST(S3Address, OrInTheHostsName) {
  const auto address = ParseS3Address("https://farm.s3.example", /*bucket_in_host=*/true);
  ASSERT_TRUE(address.ok()) << address.status();
  EXPECT_EQ(address->UrlOf("x"), "https://farm.s3.example/x");
  EXPECT_EQ(ParseS3Address("https://farm.s3.example/p", true)->UrlOf("x"),
            "https://farm.s3.example/p/x");
}

TEST(S3Address, EscapesBytesThatAUrlDoesNotTake) {
  const S3Address address = {"http://host", "/farm", ""};
  EXPECT_EQ(address.UrlOf("aZ09-_.~"), "http://host/farm/aZ09-_.~");
  EXPECT_EQ(address.UrlOf("a/b c*+$\xc3\xa4"), "http://host/farm/a/b%20c%2A%2B%24%C3%A4");
  EXPECT_EQ(address.UrlOf("a%2Fb?c#d"), "http://host/farm/a%252Fb%3Fc%23d");
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
