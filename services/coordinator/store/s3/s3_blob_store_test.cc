// Tests of failures between the store and the bucket. The contract tests of all blob stores are in
// blob_store_contract_test.cc, which includes this store.
#include "services/coordinator/store/s3/s3_blob_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <utility>

#include "common/base/cancel_scope.h"
#include "common/base/error.h"
#include "common/base/sha256.h"
#include "services/coordinator/store/blobs/checking_reader.h"
#include "services/coordinator/store/blobs/directory_blob_store.h"
#include "services/coordinator/store/s3/fake_s3_test.h"
#include "services/coordinator/store/s3/s3_reader.h"
#include "services/coordinator/store/sql/sqlite_database.h"

namespace slicefarm::coordinator::s3_blob_store_test {
namespace {

namespace fs = std::filesystem;

class S3BlobStoreTest : public testing::Test {
 protected:
  std::unique_ptr<S3BlobStore> Open(const std::string& tenant = "") {
    return std::make_unique<S3BlobStore>(bucket_.Client(), database_, staged_, tenant);
  }

  /// Returns the objects in the bucket.
  std::vector<fs::path> Objects() const {
    std::vector<fs::path> objects;
    for (const auto& entry : fs::directory_iterator(bucket_.directory())) {
      const std::string name = entry.path().filename();
      if (name.find("blobs%2F") != std::string::npos) objects.push_back(entry.path());
    }
    return objects;
  }

  /// Returns true if the database contains all objects in the bucket.
  bool KnowsAllObjects() const {
    const auto session = database_->Read();
    for (const fs::path& path : Objects()) {
      std::string key = path.filename();
      key = key.substr(key.find("blobs%2F"));
      for (size_t at = 0; (at = key.find("%2F")) != std::string::npos;) key.replace(at, 3, "/");
      SqlQuery query(**session,
                     "SELECT 1 FROM (SELECT object FROM s3_blobs UNION SELECT object FROM s3_loose)"
                     " WHERE object = ?");
      if (!query.Bind(key).Next()) return false;
    }
    return true;
  }

  int64_t Rows(const std::string& table) const {
    const auto session = database_->Read();
    SqlQuery query(**session, "SELECT count(*) FROM " + table);
    return query.Next() ? query.Int(0) : -1;
  }

  /// Returns all bytes of a blob, read as a download does.
  absl::StatusOr<std::string> Streamed(const std::string& digest) {
    const auto reader =
        OpenToStream(std::shared_ptr<BlobStore>(store_.get(), [](BlobStore*) {}), digest);
    if (!reader.ok()) return reader.status();
    std::string all;
    while (std::ssize(all) < (*reader)->size()) {
      const auto piece = (*reader)->Read(std::ssize(all), kBlobPieceBytes);
      if (!piece.ok()) return piece.status();
      all += *piece;
    }
    return all;
  }

  const TempDirectory directory_;
  const FakeS3 bucket_;
  const std::shared_ptr<SqlDatabase> database_ =
      *SqliteDatabase::Open(directory_.path() + "/jobs.db");
  const std::shared_ptr<BlobStore> staged_ = *DirectoryBlobStore::OpenAt(directory_.path());
  std::unique_ptr<S3BlobStore> store_ = Open();
  const std::string bytes_ = [] {
    std::string text;
    for (int i = 0; text.size() < 3'000'000; ++i) text += std::to_string(i) + "\n";
    return text;
  }();
  const std::string digest_ = Sha256Hex(bytes_);
};

struct Fault {
  std::string method;
  std::string kind;
};

class S3FaultsTest : public S3BlobStoreTest, public testing::WithParamInterface<Fault> {};

std::vector<Fault> AllFaults() {
  std::vector<Fault> faults;
  for (const char* method : {"PUT", "GET", "HEAD", "DELETE"}) {
    for (const char* kind : {"500", "503", "stall", "cut", "wrong", "lost", "403"})
      faults.push_back({method, kind});
  }
  return faults;
}

INSTANTIATE_TEST_SUITE_P(Calls, S3FaultsTest, testing::ValuesIn(AllFaults()), [](const auto& info) {
  return info.param.method + "_" + info.param.kind;
});

/// Makes a call and repeats it until it succeeds, as the callers of the store do.
template <typename Call>
void UntilDone(const Call& call) {
  absl::Status last;
  for (int tries = 0; tries < 10; ++tries) {
    last = call();
    if (last.ok()) return;
    const Reason reason = DetailOf(last).reason;
    ASSERT_TRUE(reason == Reason::kStoreFailed || reason == Reason::kBlobDigestMismatch) << last;
  }
  ADD_FAILURE() << last;
}

/// Returns the largest number of faults in a row, which is more than the number of tries. For
/// stalls it is one, because each takes a second. Three reads in a row with wrong bytes would count
/// as damage.
int MostTimes(const Fault& fault) {
  if (fault.kind == "stall") return 1;
  return fault.method == "GET" && fault.kind == "wrong" ? 2 : 5;
}

// Everything that the store acknowledges must be stored. The database must contain every object, so
// that it can be deleted.
TEST_P(S3FaultsTest, NothingAcknowledgedIsLost) {
  for (const int times : {1, MostTimes(GetParam())}) {
    const std::string bytes = bytes_ + std::to_string(times);
    const std::string digest = Sha256Hex(bytes);
    const std::string mesh = "mesh " + std::to_string(times);
    const std::string mesh_digest = Sha256Hex(mesh);
    bucket_.Fail(GetParam().method, GetParam().kind, times);
    UntilDone([&] { return store_->Put(bytes).status(); });
    UntilDone([&] { return store_->Append(mesh_digest, 0, mesh).status(); });
    UntilDone([&] { return store_->Finish(mesh_digest, std::ssize(mesh)).status(); });
    UntilDone([&] { return store_->Put(bytes).status(); });  // checks that the blob exists
    EXPECT_TRUE(store_->Status(digest)->complete);
    EXPECT_TRUE(store_->Status(mesh_digest)->complete);
    UntilDone([&] {
      const auto streamed = Streamed(digest);
      EXPECT_TRUE(!streamed.ok() || *streamed == bytes);
      return streamed.status();
    });
    UntilDone([&] {
      const auto read = store_->Get(mesh_digest);
      EXPECT_TRUE(!read.ok() || *read == mesh);
      return read.status();
    });
    UntilDone([&] { return store_->Delete(mesh_digest, 0).status(); });
    EXPECT_EQ(store_->Status(mesh_digest)->committed_size, 0);
  }
  EXPECT_TRUE(KnowsAllObjects());
  // Simulates the next day.
  ASSERT_TRUE((*database_->Write())->Execute("UPDATE s3_loose SET since_us = 0").ok());
  UntilDone([&] { return store_->DropDamaged(0).status(); });
  EXPECT_EQ(std::ssize(Objects()), Rows("s3_blobs"));
  EXPECT_EQ(Rows("s3_loose"), 0);
}

// A wait for a bucket that is unreachable or silent must end when it is cancelled. Otherwise this
// test takes an hour.
TEST_F(S3BlobStoreTest, AWaitForTheBucketEndsWhenItIsNotWantedAnyMore) {
  // Cancellation is checked often between two tries, and once per second while no bytes arrive.
  for (const auto& [kind, looks] : {std::pair("503", 30), std::pair("stall", 3)}) {
    S3Options options = bucket_.Options();
    options.http.stall = std::chrono::hours(1);
    options.first_pause = std::chrono::hours(1);
    S3BlobStore store(std::make_shared<S3Client>(options), database_, staged_, "");
    bucket_.Fail("PUT", kind, 1);
    std::atomic<int> asked = 0;
    const CancelScope scope(CancelToken([&, looks = looks] { return ++asked > looks; }));
    const auto put = store.Put("a small one");
    EXPECT_TRUE(absl::IsCancelled(put.status())) << put.status();
    EXPECT_EQ(DetailOf(put.status()).reason, Reason::kCancelled);
  }
  EXPECT_TRUE(store_->Put(bytes_).ok());
}

TEST_F(S3BlobStoreTest, AWrongSecretIsTold) {
  EXPECT_TRUE(bucket_.Client()->Probe().ok());
  const absl::Status refused = bucket_.Client("another")->Probe();
  EXPECT_TRUE(absl::IsPermissionDenied(refused)) << refused;
  EXPECT_NE(refused.message().find("SignatureDoesNotMatch"), std::string::npos) << refused;
}

// An object without a row remains if a process is killed between the two steps. The sweep deletes
// it a day later, not before.
TEST_F(S3BlobStoreTest, AnObjectOfAPutThatDidNotEndGoes) {
  S3Index index(database_, "");
  const int64_t day_ago = 1'000;
  ASSERT_TRUE(index.Begin("blobs/aa/left", day_ago).ok());
  ASSERT_TRUE(index.Begin("blobs/aa/young", INT64_MAX).ok());
  const BodySource body{3, [](int64_t, int64_t) { return absl::StatusOr<std::string>("abc"); }};
  for (const char* key : {"blobs/aa/left", "blobs/aa/young"})
    ASSERT_TRUE(bucket_.Client()->Put(key, Sha256Hex("abc"), body).ok());
  ASSERT_EQ(Objects().size(), 2u);
  ASSERT_TRUE(store_->DropDamaged(0).ok());
  EXPECT_EQ(Objects().size(), 1u);
  EXPECT_EQ(Rows("s3_loose"), 1);
  // A process that puts the object too late gets an error, because the object does not belong to it
  // any more.
  EXPECT_TRUE(absl::IsAborted(index.Complete("x", {"blobs/aa/left", 3}, 5).status()));
}

TEST_F(S3BlobStoreTest, AnObjectThatIsGoneIsToldAndPutAgain) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  fs::remove(Objects().at(0));
  EXPECT_TRUE(absl::IsDataLoss(store_->Get(digest_).status()));
  EXPECT_FALSE(store_->Status(digest_)->complete) << "it can be uploaded again";
  ASSERT_TRUE(store_->Put(bytes_).ok());
  EXPECT_EQ(*store_->Get(digest_), bytes_);
  fs::remove(Objects().at(0));
  ASSERT_TRUE(store_->Put(bytes_).ok()) << "without a look at it before";
  EXPECT_EQ(*store_->Get(digest_), bytes_);
}

TEST_F(S3BlobStoreTest, ADamagedObjectIsPutAside) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  const fs::path object = Objects().at(0);
  std::fstream(object, std::ios::in | std::ios::out).put('x');
  EXPECT_EQ(DetailOf(Streamed(digest_).status()).reason, Reason::kBlobDigestMismatch);
  EXPECT_FALSE(store_->Status(digest_)->complete);
  EXPECT_TRUE(fs::exists(object));
  ASSERT_TRUE(store_->Put(bytes_).ok());
  EXPECT_EQ(*Streamed(digest_), bytes_);
  ASSERT_TRUE(store_->DropDamaged(3600).ok());
  EXPECT_TRUE(fs::exists(object)) << "for some time";
  ASSERT_TRUE(store_->DropDamaged(0).ok());
  EXPECT_FALSE(fs::exists(object));
}

// The deletion of an old object may run after its blob was put again. It does no harm, because the
// objects have different names.
TEST_F(S3BlobStoreTest, ALateDeletionTakesNothingNew) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  bucket_.Fail("DELETE", "503", 4);
  ASSERT_TRUE(*store_->Delete(digest_, 0));
  EXPECT_FALSE(store_->Status(digest_)->complete);
  ASSERT_TRUE(store_->Put(bytes_).ok());
  EXPECT_EQ(Objects().size(), 2u);
  ASSERT_TRUE(store_->DropDamaged(3600).ok());
  EXPECT_EQ(Objects().size(), 1u);
  EXPECT_EQ(*store_->Get(digest_), bytes_);
}

TEST_F(S3BlobStoreTest, WhatWasThereBeforeTheBucketIsReadAndMoves) {
  ASSERT_TRUE(staged_->Put(bytes_).ok());
  ASSERT_TRUE(staged_->Append(Sha256Hex("abc"), 0, "ab").ok());
  EXPECT_TRUE(store_->Keep(digest_)->complete);
  EXPECT_EQ(*store_->Get(digest_), bytes_);
  const auto reader = store_->OpenUnchecked(digest_);
  ASSERT_TRUE(reader.ok()) << reader.status();
  int moved = 0;
  ASSERT_TRUE(store_
                  ->MoveStaged([&](const BlobEntry& blob) {
                    EXPECT_EQ(blob.digest, digest_);
                    ++moved;
                  })
                  .ok());
  EXPECT_EQ(moved, 1);
  EXPECT_FALSE(staged_->Status(digest_)->complete);
  EXPECT_EQ(*store_->Get(digest_), bytes_);
  EXPECT_EQ(store_->KeptBytes().value_or(0), std::ssize(bytes_) + 2) << "an upload stays";
  EXPECT_EQ(*(*reader)->Read(100, 50), bytes_.substr(100, 50)) << "who had it open goes on";
  ASSERT_TRUE(store_->MoveStaged([&](const BlobEntry&) { ++moved; }).ok());
  EXPECT_EQ(moved, 1);
}

TEST_F(S3BlobStoreTest, AMoveGoesOnWhereItEnded) {
  const std::vector<std::string> texts = {"a", "b", "c"};
  for (const std::string& text : texts) ASSERT_TRUE(staged_->Put(text).ok());
  bucket_.Fail("PUT", "403", 1);
  int moved = 0;
  const auto count = [&](const BlobEntry&) { ++moved; };
  EXPECT_FALSE(store_->MoveStaged(count).ok());
  EXPECT_TRUE(store_->MoveStaged(count).ok());
  EXPECT_EQ(moved, 3);
  for (const std::string& text : texts) EXPECT_EQ(*store_->Get(Sha256Hex(text)), text);
}

// The rows of PostgreSQL's reader are gone.
TEST_F(S3BlobStoreTest, AReaderWhoseBytesMoveGoesOnInTheBucket) {
  class Gone : public BlobReader {
   public:
    explicit Gone(int64_t size) : size_(size) {}
    int64_t size() const override { return size_; }

   private:
    absl::StatusOr<std::string> ReadWithin(int64_t, int64_t) override { return std::string(); }
    const int64_t size_;
  };
  ASSERT_TRUE(store_->Put(bytes_).ok());
  MovingReader reader(std::make_unique<Gone>(std::ssize(bytes_)), digest_, bucket_.Client(),
                      std::make_shared<S3Index>(database_, ""));
  EXPECT_EQ(*reader.Read(5, 7), bytes_.substr(5, 7));
  EXPECT_EQ(*reader.Read(0, 7), bytes_.substr(0, 7));
}

TEST_F(S3BlobStoreTest, PiecesInOrderAreReadAhead) {
  ASSERT_TRUE(store_->Put(bytes_).ok());
  const auto reader = *store_->OpenUnchecked(digest_);
  std::string all;
  for (int64_t at = 0; at < std::ssize(bytes_); at += 65'536) all += *reader->Read(at, 65'536);
  EXPECT_EQ(all, bytes_);
  EXPECT_EQ(*reader->Read(10, 20), bytes_.substr(10, 20)) << "and others as before";
}

}  // namespace
}  // namespace slicefarm::coordinator::s3_blob_store_test
