// Contract tests of all ProfileStores. An entry in kStores adds an implementation.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "common/base/error.h"
#include "common/base/from_environment_test.h"
#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/store/jobs/profile_store.h"
#include "services/coordinator/store/jobs/sql_profile_store.h"
#include "services/coordinator/store/sql/postgres_database.h"
#include "services/coordinator/store/sql/shared_postgres_test.h"
#include "services/coordinator/store/sql/sqlite_database.h"
#include "services/coordinator/store/store_location_test.h"

namespace slicefarm::coordinator::profile_store_contract_test {
namespace {

using testing::ElementsAre;
using testing::Field;

class SqliteLocation : public StoreLocation<ProfileStore> {
 public:
  explicit SqliteLocation(const RevisionTable& table) : table_(table) {}

  std::unique_ptr<ProfileStore> Open() override {
    return std::make_unique<SqlProfileStore>(*SqliteDatabase::Open(directory_.path() + "/db"),
                                             table_);
  }

 private:
  const RevisionTable table_;
  TempDirectory directory_;
};

class PostgresLocation : public StoreLocation<ProfileStore> {
 public:
  explicit PostgresLocation(const RevisionTable& table) : table_(table) {}

  std::unique_ptr<ProfileStore> Open() override {
    return std::make_unique<SqlProfileStore>(*PostgresDatabase::Open(database_), table_);
  }

 private:
  const RevisionTable table_;
  const std::string database_ = SharedPostgres().NewDatabase();
};

const std::vector<StoreKind<ProfileStore>> kStores = {
    {"Sqlite", [] { return std::make_unique<SqliteLocation>(kProfileTable); }},
    {"Postgres", [] { return std::make_unique<PostgresLocation>(kProfileTable); }},
    {"SqlitePresets", [] { return std::make_unique<SqliteLocation>(kPresetTable); }},
    {"PostgresPresets", [] { return std::make_unique<PostgresLocation>(kPresetTable); }},
};

class ProfileStoreTest : public testing::TestWithParam<StoreKind<ProfileStore>> {
 protected:
  ProfileRecord Put(const std::string& name, const std::string& settings,
                    const std::string& tenant = "a") {
    auto put = store_->Put({tenant, name, settings, Sha256Hex(settings)}, ++now_us_);
    EXPECT_TRUE(put.ok()) << put.status();
    return *std::move(put);
  }

  std::unique_ptr<StoreLocation<ProfileStore>> location_ = GetParam().location();
  std::unique_ptr<ProfileStore> store_ = location_->Open();
  int64_t now_us_ = 1'000;
};

INSTANTIATE_TEST_SUITE_P(Stores, ProfileStoreTest, testing::ValuesIn(kStores),
                         [](const auto& info) { return info.param.name; });

TEST_P(ProfileStoreTest, RevisionsStayAsTheyWere) {
  const std::string bytes("some\0bytes", 10);
  const ProfileRecord first = Put("mk4", bytes);
  EXPECT_EQ(first, (ProfileRecord{"mk4", 1, bytes, Sha256Hex(bytes), 1'001}));
  const ProfileRecord second = Put("mk4", "other");
  EXPECT_EQ(second.revision, 2);
  EXPECT_EQ(*store_->Get("a", "mk4", 1), first);
  EXPECT_EQ(*store_->Get("a", "mk4", 2), second);
  EXPECT_EQ(*store_->Get("a", "mk4", 0), second);
  store_ = location_->Open();
  EXPECT_EQ(*store_->Get("a", "mk4", 1), first);
}

TEST_P(ProfileStoreTest, TheSameSettingsAgainMakeNoRevision) {
  const ProfileRecord first = Put("mk4", "same");
  EXPECT_EQ(Put("mk4", "same"), first);
  Put("mk4", "other");
  EXPECT_EQ(Put("mk4", "same").revision, 3) << "it is not the newest any more";
}

TEST_P(ProfileStoreTest, ARevisionMayNameTheOneItIsBasedOn) {
  const auto put = [&](const std::string& settings, int64_t base) {
    return store_->Put({"a", "mk4", settings, Sha256Hex(settings), base}, ++now_us_);
  };
  EXPECT_EQ(DetailOf(put("one", 1).status()).metadata["revision"], "0") << "there is none";
  EXPECT_EQ(put("one", 0)->revision, 1);
  EXPECT_EQ(put("two", 1)->revision, 2);
  for (const int64_t base : {0, 1, 3}) {
    const absl::Status stale = put("three", base).status();
    EXPECT_TRUE(absl::IsAborted(stale)) << stale;
    EXPECT_EQ(DetailOf(stale).reason, Reason::kProfileNotFound);
    EXPECT_EQ(DetailOf(stale).metadata["revision"], "2");
  }
  EXPECT_EQ(put("two", 1)->revision, 2) << "the same request again";
  EXPECT_EQ(store_->Get("a", "mk4", 0)->settings, "two");
}

// Each writer adds its letter to the text that it has read. Without the condition, letters are
// lost.
TEST_P(ProfileStoreTest, WritersThatReadFirstLoseNothing) {
  constexpr int kWriters = 4, kLetters = 25;
  const auto append = [&](char letter) {
    for (int i = 0; i < kLetters;) {
      const auto newest = store_->Get("a", "mk4", 0);
      const std::string settings = (newest.ok() ? newest->settings : "") + letter;
      const int64_t base = newest.ok() ? newest->revision : 0;
      const auto put = store_->Put({"a", "mk4", settings, Sha256Hex(settings), base}, 1'000);
      if (put.ok()) {
        ++i;
      } else {
        ASSERT_TRUE(absl::IsAborted(put.status())) << put.status();
      }
    }
  };
  std::vector<std::thread> writers;
  for (int i = 0; i < kWriters; ++i) writers.emplace_back(append, static_cast<char>('a' + i));
  for (std::thread& writer : writers) writer.join();
  const std::string all = store_->Get("a", "mk4", 0)->settings;
  for (int i = 0; i < kWriters; ++i)
    EXPECT_EQ(std::ranges::count(all, static_cast<char>('a' + i)), kLetters);
}

// In each round, a writer that has read the newest revision writes while another coordinator
// deletes the profile: the writer comes first and its revision is deleted too, or it comes too
// late.
TEST_P(ProfileStoreTest, AWriterRacedByADeleteDoesNotBringAProfileBack) {
  const int64_t rounds = FromEnvironment("SLICEFARM_RACE_ROUNDS", 100);
  const auto other = location_->Open();
  int64_t back = 0;
  for (int64_t round = 0; round < rounds; ++round) {
    const ProfileRecord read = Put("mk4", "read");
    absl::Status put;
    std::thread writer([&] {
      put = store_->Put({"a", "mk4", "written", "digest", read.revision}, 1'000).status();
    });
    EXPECT_TRUE(other->Delete("a", "mk4", 0, 1'000).ok());
    writer.join();
    EXPECT_TRUE(put.ok() || absl::IsAborted(put)) << put;
    back += store_->Get("a", "mk4", 0).ok() ? 1 : 0;
  }
  EXPECT_EQ(back, 0);
}

TEST_P(ProfileStoreTest, WhatIsNotThereIsToldByName) {
  Put("mk4", "settings");
  for (const auto& [tenant, name, revision] :
       {std::tuple{"a", "mk3", 0}, {"a", "mk4", 2}, {"b", "mk4", 0}, {"b", "mk4", 1}}) {
    const absl::Status missing = store_->Get(tenant, name, revision).status();
    EXPECT_TRUE(absl::IsNotFound(missing));
    EXPECT_EQ(DetailOf(missing).reason, Reason::kProfileNotFound);
    EXPECT_NE(missing.message().find(name), absl::string_view::npos);
  }
}

TEST_P(ProfileStoreTest, ListsTheNewestOfEachByName) {
  for (const char* name : {"c", "a", "b"}) Put(name, "1");
  Put("b", "2");
  Put("z", "1", "another tenant");
  const auto name = [](const char* value) { return Field(&ProfileRecord::name, value); };
  const auto all = *store_->List("a", "", 10);
  EXPECT_THAT(all, ElementsAre(name("a"), name("b"), name("c")));
  EXPECT_EQ(all[1].revision, 2);
  EXPECT_EQ(all[1].settings, "");
  EXPECT_THAT(*store_->List("a", "", 2), ElementsAre(name("a"), name("b")));
  EXPECT_THAT(*store_->List("a", "b", 2), ElementsAre(name("c")));
}

TEST_P(ProfileStoreTest, WhatIsDeletedIsGoneAndItsNumberIsNotGivenAgain) {
  const auto is_gone = [&](int64_t revision) {
    return absl::IsNotFound(store_->Get("a", "mk4", revision).status());
  };
  for (const char* settings : {"1", "2", "3"}) Put("mk4", settings);
  ASSERT_TRUE(store_->Delete("a", "mk4", 3, ++now_us_).ok());
  EXPECT_TRUE(is_gone(3));
  EXPECT_EQ(store_->Get("a", "mk4", 0)->revision, 2);
  EXPECT_EQ(store_->List("a", "", 9)->front().revision, 2);
  EXPECT_EQ(Put("mk4", "2").revision, 2);
  EXPECT_EQ(Put("mk4", "3").revision, 4);
  ASSERT_TRUE(store_->Delete("a", "mk4", 0, ++now_us_).ok());
  for (int64_t revision = 0; revision <= 4; ++revision) EXPECT_TRUE(is_gone(revision));
  EXPECT_THAT(*store_->List("a", "", 9), testing::IsEmpty());
  EXPECT_EQ(Put("mk4", "1").revision, 5);
}

TEST_P(ProfileStoreTest, OnlyWhatIsThereIsDeleted) {
  Put("mk4", "1");
  Put("mk4", "1", "b");
  EXPECT_TRUE(absl::IsNotFound(store_->Delete("a", "mk3", 0, 9)));
  EXPECT_TRUE(absl::IsNotFound(store_->Delete("a", "mk4", 2, 9)));
  ASSERT_TRUE(store_->Delete("a", "mk4", 0, 9).ok());
  EXPECT_TRUE(absl::IsNotFound(store_->Delete("a", "mk4", 0, 9)));
  EXPECT_TRUE(store_->Get("b", "mk4", 1).ok());
}

TEST_P(ProfileStoreTest, RevisionsThatManyFollowedLongAgoExpire) {
  constexpr int64_t kKept = ProfileStore::kKeptRevisions;
  for (int64_t i = 1; i <= kKept + 3; ++i) Put("mk4", std::to_string(i));
  Put("alone", "1");
  Put("deleted", "1");
  ASSERT_TRUE(store_->Delete("a", "deleted", 1, ++now_us_).ok());
  EXPECT_EQ(*store_->Expire(0), 0) << "long ago nothing was there";
  const int64_t second_last_us = 1'000 + kKept + 2;
  EXPECT_EQ(*store_->Expire(second_last_us + 1), 2);
  EXPECT_FALSE(store_->Get("a", "mk4", 2).ok());
  EXPECT_TRUE(store_->Get("a", "mk4", 3).ok()) << "the one that makes it too old is too new";
  EXPECT_EQ(*store_->Expire(now_us_ + 1), 2) << "one more of them, and the deleted one";
  EXPECT_TRUE(store_->Get("a", "alone", 1).ok()) << "however old";
  EXPECT_EQ(*store_->Expire(now_us_ + 1), 0);
}

TEST(SqlProfileStore, StoresAsManyBytesAsTheTableAllows) {
  constexpr RevisionTable kSmall = {"presets", "bundle of presets", 3, 10};
  SqliteLocation location(kSmall);
  const auto store = location.Open();
  const auto put = [&](const std::string& name, const std::string& bytes) {
    return store->Put({"a", name, bytes, Sha256Hex(bytes)}, 1).status();
  };
  EXPECT_TRUE(put("a", "1234567").ok());
  const absl::Status full = put("b", "4444");
  EXPECT_EQ(DetailOf(full).reason, Reason::kRequestTooLarge) << full;
  EXPECT_TRUE(put("b", "333").ok());
  EXPECT_TRUE(put("a", "").ok()) << "it takes no bytes";
  EXPECT_EQ(DetailOf(put("c", "")).reason, Reason::kRequestTooLarge) << "a fourth revision";
  EXPECT_TRUE(store->Put({"b", "c", "1234567890", "d"}, 1).ok()) << "another tenant";
  ASSERT_TRUE(store->Delete("a", "a", 0, 2).ok());
}

TEST_P(ProfileStoreTest, RevisionsOfManyWritersAreAllThere) {
  constexpr int kWriters = 4;
  constexpr int kEach = 10;
  std::vector<std::thread> writers;
  for (int w = 0; w < kWriters; ++w) {
    writers.emplace_back([&, w] {
      for (int i = 0; i < kEach; ++i) {
        const std::string text = std::to_string(w) + "." + std::to_string(i);
        EXPECT_TRUE(store_->Put({"a", "mk4", text, text}, 1).ok());
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  std::set<std::string> seen;
  for (int revision = 1; revision <= kWriters * kEach; ++revision)
    seen.insert(store_->Get("a", "mk4", revision)->settings);
  EXPECT_EQ(seen.size(), kWriters * kEach);
}

}  // namespace
}  // namespace slicefarm::coordinator::profile_store_contract_test
