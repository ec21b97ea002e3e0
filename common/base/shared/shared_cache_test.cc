#include "common/base/shared/shared_cache.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace slicefarm::shared_cache_test {
namespace {

SharedBytes Bytes(const std::string& bytes, const std::string& kind = "text") {
  return {kind, SharedDigest(kind, bytes), bytes};
}

class SharedCacheTest : public testing::Test {
 protected:
  absl::StatusOr<Shared<std::string>> Take(const SharedBytes& bytes) {
    return cache_.Take<std::string>(bytes.digest, bytes.kind, [this](std::string_view text) {
      ++reads_;
      return absl::StatusOr<std::string>(std::string(text));
    });
  }

  SharedCache cache_{10};
  int reads_ = 0;
};

TEST_F(SharedCacheTest, WhatIsPutIsReadOnce) {
  const SharedBytes abc = Bytes("abc");
  EXPECT_FALSE(cache_.Has(abc.digest));
  cache_.Put(abc);
  cache_.Put(abc);
  EXPECT_TRUE(cache_.Has(abc.digest));
  const auto first = Take(abc);
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_EQ(**first, "abc");
  EXPECT_EQ(&**Take(abc), &**first);
  EXPECT_EQ(reads_, 1);
  EXPECT_EQ(cache_.counts().hits, 2);
  EXPECT_EQ(cache_.counts().bytes, 3);
  EXPECT_EQ(cache_.counts().entries, 1);
}

TEST_F(SharedCacheTest, WhatIsNotThereIsNamed) {
  const SharedBytes abc = Bytes("abc");
  const absl::Status status = Take(abc).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kSharedMissing);
  EXPECT_EQ(MissingDigest(status), abc.digest);
  EXPECT_EQ(MissingDigest(absl::InternalError("")), "");
  EXPECT_EQ(MissingDigest(absl::OkStatus()), "");
  EXPECT_EQ(cache_.counts().misses, 1);
}

TEST_F(SharedCacheTest, TheOneNotAskedForLongestGoes) {
  const SharedBytes a = Bytes("aaaa"), b = Bytes("bbbb"), c = Bytes("cccc");
  cache_.Put(a);
  cache_.Put(b);
  ASSERT_TRUE(Take(a).ok());
  cache_.Put(c);
  EXPECT_TRUE(cache_.Has(a.digest));
  EXPECT_FALSE(cache_.Has(b.digest));
  EXPECT_TRUE(cache_.Has(c.digest));
  EXPECT_EQ(cache_.counts().evicted, 1);
  EXPECT_EQ(cache_.counts().bytes, 8);
}

TEST_F(SharedCacheTest, WhatIsUsedOutlivesItsPlace) {
  const SharedBytes a = Bytes("aaaa");
  cache_.Put(a);
  const auto taken = Take(a);
  cache_.Put(Bytes("0123456789"));
  EXPECT_FALSE(cache_.Has(a.digest));
  EXPECT_EQ(**taken, "aaaa");
}

TEST_F(SharedCacheTest, AValueThatIsTooLongIsKeptAlone) {
  const SharedBytes a = Bytes("aaaa"), whole = Bytes("0123456789abc");
  cache_.Put(a);
  cache_.Put(whole);
  EXPECT_FALSE(cache_.Has(a.digest));
  EXPECT_EQ(**Take(whole), "0123456789abc");
  cache_.Put(a);
  EXPECT_FALSE(cache_.Has(whole.digest));
  EXPECT_TRUE(cache_.Has(a.digest));
}

TEST_F(SharedCacheTest, KindsAreKeptApart) {
  const SharedBytes text = Bytes(""), other = Bytes("", "other");
  EXPECT_NE(text.digest, other.digest);
  cache_.Put(text);
  EXPECT_EQ(DetailOf(Take(other).status()).reason, Reason::kSharedMissing);
  EXPECT_EQ(DetailOf(Take({"other", text.digest, ""}).status()).reason, Reason::kRequestMalformed);
}

TEST_F(SharedCacheTest, WhatCannotBeReadIsAnError) {
  const SharedBytes a = Bytes("a");
  cache_.Put(a);
  const auto fail = [](std::string_view) -> absl::StatusOr<int> {
    return absl::InvalidArgumentError("no number");
  };
  for (int i = 0; i < 2; ++i)
    EXPECT_EQ(cache_.Take<int>(a.digest, a.kind, fail).status().message(), "no number");
}

TEST_F(SharedCacheTest, ManyThreadsReadOnce) {
  const SharedBytes a = Bytes("aaaa");
  cache_.Put(a);
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back([&] { EXPECT_EQ(**Take(a), "aaaa"); });
  threads.clear();
  EXPECT_EQ(reads_, 1);
}

}  // namespace
}  // namespace slicefarm::shared_cache_test
