// Contract tests of all BlobStores. An entry in kStores adds an implementation.
#include "services/coordinator/store/blobs/blob_stores.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"

namespace slicefarm::coordinator::blob_stores_test {
namespace {

struct Kind {
  std::string name;
  std::function<std::unique_ptr<BlobStores>(const std::string& directory)> open;
};

const std::vector<Kind> kStores = {
    {"Directory", [](const std::string& directory) { return *OpenDirectoryBlobs(directory); }},
    {"Postgres",
     [](const std::string&) {
       return MakePostgresBlobs(*PostgresDatabase::Open(SharedPostgres().NewDatabase()));
     }},
};

class BlobStoresTest : public testing::TestWithParam<Kind> {
 protected:
  BlobStore& Of(const std::string& tenant) {
    auto store = blobs_->Of(tenant);
    EXPECT_TRUE(store.ok()) << store.status();
    held_.push_back(*store);
    return **store;
  }

  TempDirectory directory_;
  std::unique_ptr<BlobStores> blobs_ = GetParam().open(directory_.path());
  std::vector<std::shared_ptr<BlobStore>> held_;
  const std::string bytes_ = std::string(100'000, 'x');
  const std::string digest_ = Sha256Hex(bytes_);
};

INSTANTIATE_TEST_SUITE_P(Stores, BlobStoresTest, testing::ValuesIn(kStores),
                         [](const auto& info) { return info.param.name; });

TEST_P(BlobStoresTest, ATenantsBlobsAreHisAlone) {
  ASSERT_TRUE(Of("a").Put(bytes_).ok());
  for (const char* other : {"b", ""}) {
    EXPECT_FALSE(Of(other).Status(digest_)->complete);
    EXPECT_EQ(Of(other).Status(digest_)->committed_size, 0);
    EXPECT_FALSE(Of(other).Keep(digest_)->complete);
    EXPECT_EQ(DetailOf(Of(other).Open(digest_).status()).reason, Reason::kBlobNotFound);
    EXPECT_EQ(DetailOf(Of(other).Get(digest_).status()).reason, Reason::kBlobNotFound);
    EXPECT_FALSE(*Of(other).Delete(digest_, 0));
    EXPECT_TRUE(Of(other).ForEach([](const BlobEntry&) { FAIL(); }).ok());
  }
  EXPECT_EQ(*Of("a").Get(digest_), bytes_);
}

TEST_P(BlobStoresTest, UploadsOfTheSameGoOnApart) {
  ASSERT_TRUE(Of("a").Append(digest_, 0, bytes_.substr(0, 60'000)).ok());
  EXPECT_EQ(Of("b").Status(digest_)->committed_size, 0);
  EXPECT_EQ(DetailOf(Of("b").Append(digest_, 60'000, bytes_.substr(60'000)).status()).reason,
            Reason::kUploadOffset);
  // The bytes that one tenant sends do not damage the other tenant's upload.
  ASSERT_TRUE(Of("b").Append(digest_, 0, std::string(100'000, '!')).ok());
  EXPECT_EQ(DetailOf(Of("b").Finish(digest_, 100'000).status()).reason,
            Reason::kBlobDigestMismatch);
  ASSERT_TRUE(Of("a").Append(digest_, 60'000, bytes_.substr(60'000)).ok());
  EXPECT_TRUE(Of("a").Finish(digest_, 100'000)->complete);
  EXPECT_FALSE(Of("b").Status(digest_)->complete);
}

TEST_P(BlobStoresTest, WhatOneDeletesTheOtherKeeps) {
  ASSERT_TRUE(Of("a").Put(bytes_).ok());
  ASSERT_TRUE(Of("b").Put(bytes_).ok());
  EXPECT_TRUE(*Of("a").Delete(digest_, 0));
  EXPECT_EQ(*Of("b").Get(digest_), bytes_);
  EXPECT_FALSE(Of("a").Status(digest_)->complete);
}

TEST_P(BlobStoresTest, KnowsWhoHasBlobs) {
  EXPECT_THAT(*blobs_->Tenants(), testing::ElementsAre(""));
  ASSERT_TRUE(Of("a").Put(bytes_).ok());
  ASSERT_TRUE(Of("b").Append(digest_, 0, "part").ok());
  ASSERT_TRUE(Of("").Put(bytes_).ok());
  EXPECT_THAT(*blobs_->Tenants(), testing::UnorderedElementsAre("", "a", "b"));
}

TEST_P(BlobStoresTest, NamesThatAreNoTenantsLeadNowhere) {
  for (const std::string& name : {std::string(".."), std::string("a/b"), std::string("A"),
                                  std::string("a\0", 2), std::string("../../etc")}) {
    EXPECT_EQ(DetailOf(blobs_->Of(name).status()).reason, Reason::kRequestMalformed) << name;
  }
}

TEST(DirectoryBlobs, TheNamelessOnesStayWhereTheyWere) {
  TempDirectory directory;
  const auto blobs = *OpenDirectoryBlobs(directory.path());
  const std::string digest = *(*blobs->Of(""))->Put("some bytes");
  ASSERT_TRUE((*blobs->Of("acme"))->Put("some bytes").ok());
  const std::string file = "/blobs/" + digest.substr(0, 2) + "/" + digest;
  EXPECT_TRUE(std::filesystem::exists(directory.path() + file));
  EXPECT_TRUE(std::filesystem::exists(directory.path() + "/tenants/acme" + file));
}

}  // namespace
}  // namespace slicefarm::coordinator::blob_stores_test
