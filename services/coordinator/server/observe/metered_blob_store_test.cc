#include "services/coordinator/server/observe/metered_blob_store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "common/base/sha256.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/server/observe/metric_values_test.h"

namespace slicefarm::coordinator::metered_blob_store_test {
namespace {

class MeteredBlobStoreTest : public testing::Test {
 protected:
  std::optional<double> Value(const std::string& name) {
    return MetricValue(registry_.Collect(), name);
  }

  /// Damages every blob of the store.
  void Spoil() {
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(directory_.path() + "/blobs")) {
      if (file.is_regular_file()) std::ofstream(file.path(), std::ios::trunc) << "other";
    }
  }

  TempDirectory directory_;
  std::unique_ptr<BlobStores> inner_ = *OpenDirectoryBlobs(directory_.path());
  prometheus::Registry registry_;
  MeteredBlobStores stores_{*inner_, registry_};
  std::shared_ptr<BlobStore> store_ = *stores_.Of("");
};

TEST_F(MeteredBlobStoreTest, CountsWhatIsWritten) {
  ASSERT_TRUE(store_->Put("12345").ok());
  ASSERT_TRUE(store_->Append(Sha256Hex("abc"), 0, "ab").ok());
  EXPECT_FALSE(store_->Append(Sha256Hex("abc"), 7, "beyond").ok());
  EXPECT_EQ(Value("slicefarm_blob_written_bytes_total"), 7);
}

TEST_F(MeteredBlobStoreTest, KnowsWhatIsThereOnceItWasGoneThrough) {
  ASSERT_TRUE(store_->Put("12345").ok());
  ASSERT_TRUE(store_->Put("678").ok());
  EXPECT_EQ(Value("slicefarm_blob_bytes"), 0);
  int visited = 0;
  ASSERT_TRUE(store_->ForEach([&](const BlobEntry&) { ++visited; }).ok());
  EXPECT_EQ(visited, 2);
  EXPECT_EQ(Value("slicefarm_blob_bytes"), 8);
  EXPECT_EQ(Value("slicefarm_blobs"), 2);
}

TEST_F(MeteredBlobStoreTest, AddsUpWhatTenantsHave) {
  const auto of_a = *stores_.Of("a");
  ASSERT_TRUE(of_a->Put("12345").ok());
  ASSERT_TRUE(store_->Put("678").ok());
  for (const auto& store : {of_a, store_, of_a}) {
    ASSERT_TRUE(store->ForEach([](const BlobEntry&) {}).ok());
  }
  EXPECT_EQ(Value("slicefarm_blob_bytes"), 8);
  EXPECT_EQ(Value("slicefarm_blobs"), 2);
}

TEST_F(MeteredBlobStoreTest, CountsDamage) {
  const std::string digest = *store_->Put("12345");
  ASSERT_TRUE(store_->Get(digest).ok());
  EXPECT_TRUE(absl::IsNotFound(store_->Get(Sha256Hex("none")).status()));
  EXPECT_EQ(Value("slicefarm_blob_corrupt_total"), 0);
  Spoil();
  EXPECT_TRUE(absl::IsDataLoss(store_->Open(digest).status()));
  EXPECT_EQ(Value("slicefarm_blob_corrupt_total"), 1);
}

}  // namespace
}  // namespace slicefarm::coordinator::metered_blob_store_test
