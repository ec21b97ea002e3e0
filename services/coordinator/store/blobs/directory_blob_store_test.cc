#include "services/coordinator/store/blobs/directory_blob_store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/blobs/checking_reader.h"

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

/// Reads a blob as a download does.
absl::Status Stream(const std::shared_ptr<BlobStore>& store, const std::string& digest) {
  const auto reader = OpenToStream(store, digest);
  if (!reader.ok()) return reader.status();
  for (int64_t at = 0; at < (*reader)->size(); at += 4)
    if (const auto read = (*reader)->Read(at, 4); !read.ok()) return read.status();
  return absl::OkStatus();
}

TEST_F(DirectoryBlobStoreTest, ABlobThatWasCheckedIsNotReadAgainToOpenIt) {
  const std::string digest = *store_->Put("some bytes");
  ASSERT_TRUE(store_->Open(digest).ok());
  ASSERT_TRUE(store_->Keep(digest)->complete) << "which changes its date";
  const auto written = std::filesystem::last_write_time(PathOf(digest));
  Damage(digest);
  std::filesystem::last_write_time(PathOf(digest), written);  // simulates a disk that changes bits
  EXPECT_TRUE(store_->Open(digest).ok()) << "was read";
  std::filesystem::last_write_time(PathOf(digest), written + std::chrono::seconds(1));
  EXPECT_TRUE(absl::IsDataLoss(store_->Open(digest).status())) << "was written since";
}

TEST_F(DirectoryBlobStoreTest, AStreamIsCheckedWhileItIsRead) {
  const std::shared_ptr<BlobStore> store = std::move(store_);
  const std::string digest = *store->Put("some bytes");
  EXPECT_TRUE(Stream(store, digest).ok());
  Damage(digest);
  const absl::Status status = Stream(store, digest);
  EXPECT_TRUE(absl::IsDataLoss(status)) << status;
  EXPECT_EQ(DetailOf(status).reason, Reason::kBlobDigestMismatch);
  EXPECT_FALSE(store->Status(digest)->complete) << "was not put aside";
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
