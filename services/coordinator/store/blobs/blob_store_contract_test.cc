// Contract tests of all BlobStores. An entry in kStores adds an implementation.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <thread>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/blobs/checking_reader.h"
#include "services/coordinator/store/blobs/directory_blob_store.h"
#include "services/coordinator/store/blobs/postgres_blob_store.h"
#include "services/coordinator/store/s3/fake_s3_test.h"
#include "services/coordinator/store/s3/s3_blob_store.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"
#include "services/coordinator/store/sql/sqlite_database.h"
#include "services/coordinator/store/store_location_test.h"

namespace slicefarm::coordinator::blob_store_contract_test {
namespace {

class DirectoryLocation : public StoreLocation<BlobStore> {
 public:
  std::unique_ptr<BlobStore> Open() override {
    auto store = DirectoryBlobStore::OpenAt(directory_.path() + "/deep/down");
    EXPECT_TRUE(store.ok()) << store.status();
    return *std::move(store);
  }

 private:
  TempDirectory directory_;
};

class PostgresLocation : public StoreLocation<BlobStore> {
 public:
  explicit PostgresLocation(std::string tenant = "") : tenant_(std::move(tenant)) {}

  std::unique_ptr<BlobStore> Open() override {
    auto database = PostgresDatabase::Open(database_);
    EXPECT_TRUE(database.ok()) << database.status();
    return std::make_unique<PostgresBlobStore>(*std::move(database), tenant_);
  }

 private:
  const std::string tenant_;
  const std::string database_ = SharedPostgres().NewDatabase();
};

/// Location of an S3 store. Its uploads are stored beside the jobs, in a directory or in
/// PostgreSQL.
class S3Location : public StoreLocation<BlobStore> {
 public:
  explicit S3Location(bool postgres) : postgres_(postgres) {}

  std::unique_ptr<BlobStore> Open() override {
    if (!postgres_) {
      auto database = SqliteDatabase::Open(directory_.path() + "/jobs.db");
      auto staged = DirectoryBlobStore::OpenAt(directory_.path());
      EXPECT_TRUE(database.ok() && staged.ok()) << database.status() << staged.status();
      return std::make_unique<S3BlobStore>(bucket_.Client(), *std::move(database),
                                           *std::move(staged), "");
    }
    if (name_.empty()) name_ = SharedPostgres().NewDatabase();
    std::shared_ptr<SqlDatabase> database = *PostgresDatabase::Open(name_);
    auto staged = std::make_shared<PostgresBlobStore>(database, "acme");
    return std::make_unique<S3BlobStore>(bucket_.Client(), database, std::move(staged), "acme");
  }

 private:
  const bool postgres_;
  TempDirectory directory_;
  FakeS3 bucket_;
  std::string name_;
};

const std::vector<StoreKind<BlobStore>> kStores = {
    {"Directory", [] { return std::make_unique<DirectoryLocation>(); }},
    {"Postgres", [] { return std::make_unique<PostgresLocation>(); }},
    {"PostgresOfATenant", [] { return std::make_unique<PostgresLocation>("acme"); }},
    {"S3BesideADirectory", [] { return std::make_unique<S3Location>(/*postgres=*/false); }},
    {"S3OfATenantBesidePostgres", [] { return std::make_unique<S3Location>(/*postgres=*/true); }},
};

class BlobStoreTest : public testing::TestWithParam<StoreKind<BlobStore>> {
 protected:
  std::unique_ptr<StoreLocation<BlobStore>> location_ = GetParam().location();
  std::unique_ptr<BlobStore> store_ = location_->Open();
  const std::string bytes_ = std::string("some\0bytes", 10) + std::string(200'000, 'x');
  const std::string digest_ = Sha256Hex(bytes_);
};

INSTANTIATE_TEST_SUITE_P(Stores, BlobStoreTest, testing::ValuesIn(kStores),
                         [](const auto& info) { return info.param.name; });

TEST_P(BlobStoreTest, GivesBackWhatWasPut) {
  EXPECT_EQ(*store_->Put(bytes_), digest_);
  EXPECT_EQ(*store_->Put(bytes_), digest_);
  EXPECT_EQ(*store_->Get(digest_), bytes_);
  EXPECT_TRUE(store_->Status(digest_)->complete);
  EXPECT_EQ(store_->Status(digest_)->committed_size, static_cast<int64_t>(bytes_.size()));
}

/// Returns a text that needs several pieces in a database.
SpooledText LongText() {
  auto spool = *SpoolFile::Make("");
  const SpoolFile::Chunk chunk = *spool->Add(std::string(1'500'000, 'y'));
  SpooledText text(std::move(spool));
  text.Add(std::string("begin"));
  for (int i = 0; i < 3; ++i) text.Add(chunk);
  text.Add(std::string("end"));
  return text;
}

TEST_P(BlobStoreTest, GivesBackTextsThatDoNotFitIntoMemory) {
  const SpooledText text = LongText();
  const std::string whole = *text.Whole();
  const auto digest = store_->PutText(text);
  ASSERT_TRUE(digest.ok()) << digest.status();
  EXPECT_EQ(*digest, Sha256Hex(whole));
  EXPECT_EQ(*store_->PutText(text), *digest);
  EXPECT_TRUE(*store_->Get(*digest) == whole);
  EXPECT_EQ(store_->Status(*digest)->committed_size, text.size());
}

TEST_P(BlobStoreTest, ATextThatCannotBeReadIsNoBlob) {
  SpooledText text(*SpoolFile::Make(""));
  text.Add(std::string(100, 'x'));
  text.Add(SpoolFile::Chunk{0, 100});  // the spool is empty
  EXPECT_EQ(DetailOf(store_->PutText(text).status()).reason, Reason::kStoreFailed);
  int blobs = 0;
  EXPECT_TRUE(store_->ForEach([&](const BlobEntry&) { ++blobs; }).ok());
  EXPECT_EQ(blobs, 0);
}

TEST_P(BlobStoreTest, SurvivesBeingOpenedAgain) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  ASSERT_TRUE(store_->Append(Sha256Hex("abc"), 0, "ab").ok());
  store_.reset();
  store_ = location_->Open();
  EXPECT_EQ(*store_->Get(digest_), bytes_);
  EXPECT_EQ(store_->Status(Sha256Hex("abc"))->committed_size, 2);
  EXPECT_FALSE(store_->Status(Sha256Hex("abc"))->complete);
}

TEST_P(BlobStoreTest, ReadsParts) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  const auto reader = store_->Open(digest_);
  ASSERT_TRUE(reader.ok()) << reader.status();
  EXPECT_EQ((*reader)->size(), static_cast<int64_t>(bytes_.size()));
  EXPECT_EQ(*(*reader)->Read(2, 5), bytes_.substr(2, 5));
  EXPECT_EQ(*(*reader)->Read((*reader)->size() - 1, 100), "x");
  EXPECT_EQ(*(*reader)->Read((*reader)->size(), 100), "");
  EXPECT_EQ(*(*reader)->Read((*reader)->size() + 7, 100), "");
}

TEST_P(BlobStoreTest, StreamsWhatWasPut) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  const std::shared_ptr<BlobStore> store = std::move(store_);
  const auto reader = OpenToStream(store, digest_);
  ASSERT_TRUE(reader.ok()) << reader.status();
  std::string streamed;
  while (std::ssize(streamed) < (*reader)->size()) {
    const auto piece = (*reader)->Read(std::ssize(streamed), 65'536);
    ASSERT_TRUE(piece.ok()) << piece.status();
    streamed += *piece;
  }
  EXPECT_EQ(streamed, bytes_);
  EXPECT_EQ(DetailOf(OpenToStream(store, Sha256Hex("abc")).status()).reason, Reason::kBlobNotFound);
}

TEST_P(BlobStoreTest, ABlobOfManyPiecesIsReadAsOne) {
  std::string bytes;
  for (int i = 0; bytes.size() < 2'500'000; ++i) bytes += std::to_string(i);
  const auto digest = store_->Put(bytes);
  ASSERT_TRUE(digest.ok()) << digest.status();
  EXPECT_EQ(*store_->Get(*digest), bytes);
  const auto reader = store_->Open(*digest);
  EXPECT_EQ(*(*reader)->Read(1'000'000, 1'400'000), bytes.substr(1'000'000, 1'400'000));
}

// Without an error, a client that receives fewer bytes would accept them as the whole blob.
TEST_P(BlobStoreTest, WhatGoesWhileItIsReadIsAnErrorOrStillThere) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  const auto reader = store_->Open(digest_);
  ASSERT_TRUE(*store_->Delete(digest_, 0));
  const auto read = (*reader)->Read(100, 1000);
  if (read.ok()) {
    EXPECT_EQ(*read, bytes_.substr(100, 1000));
  } else {
    EXPECT_TRUE(absl::IsDataLoss(read.status())) << read.status();
  }
}

TEST_P(BlobStoreTest, EmptyBlobsAreBlobs) {
  EXPECT_EQ(*store_->Put(""), Sha256Hex(""));
  EXPECT_EQ(*store_->Get(Sha256Hex("")), "");
}

TEST_P(BlobStoreTest, AnEmptyUploadCanBeFinished) {
  EXPECT_TRUE(store_->Finish(Sha256Hex(""), 0)->complete);
}

TEST_P(BlobStoreTest, UploadsInPieces) {
  for (size_t at = 0; at < bytes_.size(); at += 65'536) {
    EXPECT_FALSE(store_->Status(digest_)->complete);
    const auto status = store_->Append(digest_, at, bytes_.substr(at, 65'536));
    ASSERT_TRUE(status.ok()) << status.status();
    EXPECT_EQ(status->committed_size, static_cast<int64_t>(std::min(at + 65'536, bytes_.size())));
  }
  EXPECT_FALSE(store_->Get(digest_).ok()) << "not a blob yet";
  ASSERT_TRUE(store_->Finish(digest_, bytes_.size())->complete);
  EXPECT_EQ(*store_->Get(digest_), bytes_);
  EXPECT_TRUE(store_->Append(digest_, 0, "zzz")->complete) << "changes nothing";
  EXPECT_TRUE(store_->Finish(digest_, bytes_.size())->complete);
  EXPECT_EQ(*store_->Get(digest_), bytes_);
}

TEST_P(BlobStoreTest, WhatIsThereMayBeSentAgain) {
  ASSERT_TRUE(store_->Append(digest_, 0, bytes_.substr(0, 100)).ok());
  EXPECT_EQ(store_->Append(digest_, 0, bytes_.substr(0, 60))->committed_size, 100);
  EXPECT_EQ(store_->Append(digest_, 50, bytes_.substr(50, 100))->committed_size, 150);
  EXPECT_EQ(store_->Append(digest_, 150, bytes_.substr(150))->committed_size,
            static_cast<int64_t>(bytes_.size()));
  EXPECT_TRUE(store_->Finish(digest_, bytes_.size()).ok());
}

TEST_P(BlobStoreTest, AnUploadHasNoHoles) {
  ASSERT_TRUE(store_->Append(digest_, 0, "0123456789").ok());
  const absl::Status status = store_->Append(digest_, 11, "x").status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kUploadOffset);
  EXPECT_EQ(DetailOf(status).metadata.at("committed_size"), "10");
  EXPECT_EQ(DetailOf(store_->Append(digest_, -1, "x").status()).reason, Reason::kUploadOffset);
  EXPECT_EQ(DetailOf(store_->Finish(digest_, 11).status()).reason, Reason::kUploadOffset);
}

TEST_P(BlobStoreTest, OtherBytesAreRefusedAndForgotten) {
  ASSERT_TRUE(store_->Append(digest_, 0, "not these").ok());
  const absl::Status status = store_->Finish(digest_, 9).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kBlobDigestMismatch);
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_EQ(store_->Status(digest_)->committed_size, 0);
}

TEST_P(BlobStoreTest, NamesAreDigests) {
  for (const std::string name : {"", "../../etc/passwd", "ABC", "abc"}) {
    EXPECT_EQ(DetailOf(store_->Status(name).status()).reason, Reason::kRequestMalformed);
    EXPECT_FALSE(store_->Append(name, 0, "x").ok());
    EXPECT_FALSE(store_->Finish(name, 0).ok());
    EXPECT_FALSE(store_->Open(name).ok());
    EXPECT_FALSE(store_->Get(name).ok());
    EXPECT_FALSE(store_->Keep(name).ok());
    EXPECT_FALSE(store_->Delete(name, 0).ok());
  }
}

TEST_P(BlobStoreTest, DeletedBlobsAreGone) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  EXPECT_TRUE(*store_->Delete(digest_, 0));
  EXPECT_FALSE(*store_->Delete(digest_, 0));
  EXPECT_EQ(DetailOf(store_->Get(digest_).status()).reason, Reason::kBlobNotFound);
  EXPECT_EQ(DetailOf(store_->Open(digest_).status()).reason, Reason::kBlobNotFound);
  EXPECT_EQ(store_->Status(digest_)->committed_size, 0);
}

TEST_P(BlobStoreTest, WhatWasUsedIsNotDeletedAsIdle) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  EXPECT_FALSE(*store_->Delete(digest_, 3600));
  const auto kept = store_->Keep(digest_);
  EXPECT_TRUE(kept->complete);
  EXPECT_EQ(kept->committed_size, static_cast<int64_t>(bytes_.size()));
  EXPECT_EQ(*store_->Get(digest_), bytes_);
  EXPECT_FALSE(store_->Keep(std::string(64, 'b'))->complete);
}

TEST_P(BlobStoreTest, ListsBlobsAndUploads) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  const std::string upload(64, 'a');
  ASSERT_TRUE(store_->Append(upload, 0, "part").ok());
  std::map<std::string, std::pair<int64_t, bool>> listed;
  ASSERT_TRUE(store_
                  ->ForEach([&](const BlobEntry& blob) {
                    listed[blob.digest] = {blob.size, blob.complete};
                    EXPECT_GE(blob.idle_s, -1);
                    EXPECT_LT(blob.idle_s, 3600);
                  })
                  .ok());
  EXPECT_THAT(listed, testing::UnorderedElementsAre(
                          testing::Pair(digest_, testing::Pair(std::ssize(bytes_), true)),
                          testing::Pair(upload, testing::Pair(4, false))));
}

TEST_P(BlobStoreTest, KnowsHowMuchItKeeps) {
  EXPECT_EQ(*store_->KeptBytes(), 0);
  const std::string digest = *store_->Put(bytes_);
  ASSERT_TRUE(store_->Put(bytes_).ok()) << "which is there already";
  ASSERT_TRUE(store_->Append(Sha256Hex("abc"), 0, "ab").ok());
  ASSERT_TRUE(store_->Append(Sha256Hex("abc"), 1, "bc").ok());
  const int64_t blob = std::ssize(bytes_);
  EXPECT_EQ(*store_->KeptBytes(), blob + 3);
  ASSERT_TRUE(store_->Finish(Sha256Hex("abc"), 3).ok());
  EXPECT_EQ(*store_->KeptBytes(), blob + 3);
  ASSERT_TRUE(store_->Append(Sha256Hex("xyz"), 0, "not").ok());
  ASSERT_FALSE(store_->Finish(Sha256Hex("xyz"), 3).ok());
  EXPECT_EQ(*store_->KeptBytes(), blob + 3);
  store_.reset();
  store_ = location_->Open();
  EXPECT_EQ(*store_->KeptBytes(), blob + 3);
  ASSERT_TRUE(*store_->Delete(digest, 0));
  EXPECT_EQ(*store_->KeptBytes(), 3);
}

TEST_P(BlobStoreTest, OnlyDamagedBlobsAreDroppedAsSuch) {
  const std::string good = *store_->Put(bytes_);
  ASSERT_TRUE(store_->Append(Sha256Hex("abc"), 0, "ab").ok());
  EXPECT_EQ(*store_->DropDamaged(0), 0);
  EXPECT_EQ(*store_->Get(good), bytes_);
  EXPECT_EQ(store_->Status(Sha256Hex("abc"))->committed_size, 2);
}

TEST_P(BlobStoreTest, ManyMayUploadTheSame) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&, i] {
      const size_t piece = 1000 + 777 * i;
      for (size_t at = 0; at < bytes_.size(); at += piece) {
        EXPECT_TRUE(store_->Append(digest_, at, std::string_view(bytes_).substr(at, piece)).ok());
      }
      EXPECT_TRUE(store_->Finish(digest_, bytes_.size()).ok());
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(*store_->Get(digest_), bytes_);
}

}  // namespace
}  // namespace slicefarm::coordinator::blob_store_contract_test
