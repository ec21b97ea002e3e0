#include "services/coordinator/store/blobs/directory_blob_store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"

namespace slicefarm::coordinator::directory_blob_store_test {
namespace {

class DirectoryBlobStoreTest : public testing::Test {
 protected:
  std::string PathOf(const std::string& digest) const {
    return directory_.path() + "/blobs/" + digest.substr(0, 2) + "/" + digest;
  }

  void Damage(const std::string& digest) {
    std::fstream file(PathOf(digest), std::ios::in | std::ios::out | std::ios::binary);
    ASSERT_TRUE(file.is_open());
    file.seekp(3);
    file.put('!');
  }

  TempDirectory directory_;
  std::unique_ptr<DirectoryBlobStore> store_ = *DirectoryBlobStore::OpenAt(directory_.path());
};

TEST_F(DirectoryBlobStoreTest, ChangedBytesAreNoticed) {
  const std::string digest = *store_->Put("some bytes");
  Damage(digest);
  const absl::Status status = store_->Get(digest).status();
  EXPECT_TRUE(absl::IsDataLoss(status)) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kBlobDigestMismatch);
}

TEST_F(DirectoryBlobStoreTest, ABlobThatIsCutOffWhileItIsReadIsAnError) {
  const std::string digest = *store_->Put("bytes");
  const auto reader = store_->Open(digest);
  std::filesystem::resize_file(PathOf(digest), 3);
  EXPECT_EQ(*(*reader)->Read(0, 3), "byt");
  EXPECT_TRUE(absl::IsDataLoss((*reader)->Read(0, 5).status()));
}

TEST_F(DirectoryBlobStoreTest, ADamagedBlobMakesRoomForAnUpload) {
  const std::string digest = *store_->Put("some bytes");
  Damage(digest);
  EXPECT_TRUE(absl::IsDataLoss(store_->Open(digest).status()));
  EXPECT_FALSE(store_->Status(digest)->complete);
  ASSERT_TRUE(store_->Append(digest, 0, "some bytes").ok());
  ASSERT_TRUE(store_->Finish(digest, 10).ok());
  EXPECT_EQ(*store_->Get(digest), "some bytes");
}

TEST_F(DirectoryBlobStoreTest, PutMendsADamagedBlob) {
  const std::string digest = *store_->Put("some bytes");
  Damage(digest);
  ASSERT_TRUE(store_->Put("some bytes").ok());
  EXPECT_EQ(*store_->Get(digest), "some bytes");
}

TEST_F(DirectoryBlobStoreTest, WhatWasBeingWrittenIsSweptUp) {
  std::ofstream(directory_.path() + "/tmp/7") << "half";
  store_ = *DirectoryBlobStore::OpenAt(directory_.path());
  EXPECT_TRUE(std::filesystem::is_empty(directory_.path() + "/tmp"));
}

TEST_F(DirectoryBlobStoreTest, APlaceThatCannotBeIsAnError) {
  std::ofstream(directory_.path() + "/file") << "in the way";
  EXPECT_EQ(DetailOf(DirectoryBlobStore::OpenAt(directory_.path() + "/file").status()).reason,
            Reason::kStoreFailed);
}

}  // namespace
}  // namespace slicefarm::coordinator::directory_blob_store_test
