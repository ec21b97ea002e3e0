#include "services/coordinator/server/reloaded_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <prometheus/text_serializer.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"
#include "services/coordinator/algo/tenants.h"

namespace slicefarm::coordinator::reloaded_file_test {
namespace {

using std::chrono::milliseconds;

class ReloadedFileTest : public testing::Test {
 protected:
  void Write(const std::string& tenants) {
    std::ofstream(path_ + ".new") << R"({"tenants": )" << tenants << "}";
    std::filesystem::rename(path_ + ".new", path_);
  }

  auto Open() {
    return ReloadedFile<Tenants>::Open(path_, "tenants", ParseTenants, registry_,
                                       rpc::JsonLog("test"), milliseconds(1));
  }

  void AwaitUsable(const std::string& value) {
    const std::string line = "\nslicefarm_tenants_file_usable " + value + "\n";
    while (prometheus::TextSerializer().Serialize(registry_.Collect()).find(line) ==
           std::string::npos) {
      std::this_thread::yield();
    }
  }

  TempDirectory directory_;
  const std::string path_ = directory_.path() + "/tenants.json";
  prometheus::Registry registry_;
};

TEST_F(ReloadedFileTest, ANewContentReplacesTheOld) {
  Write(R"({"a": {}})");
  const auto file = Open();
  ASSERT_TRUE(file.ok()) << file.status();
  const auto before = (*file)->Get();
  EXPECT_TRUE(before->contains("a"));
  Write(R"({"b": {}})");
  while (!(*file)->Get()->contains("b")) std::this_thread::yield();
  EXPECT_FALSE((*file)->Get()->contains("a"));
  EXPECT_TRUE(before->contains("a"));  // a holder of the old content may continue to use it
}

TEST_F(ReloadedFileTest, ABadContentLeavesTheOldInForce) {
  Write(R"({"a": {}})");
  const auto file = Open();
  ASSERT_TRUE(file.ok()) << file.status();
  AwaitUsable("1");
  Write(R"({"b": {"tokenz": []}})");
  AwaitUsable("0");
  EXPECT_TRUE((*file)->Get()->contains("a"));
  Write(R"({"b": {}})");
  AwaitUsable("1");
  while (!(*file)->Get()->contains("b")) std::this_thread::yield();
  std::filesystem::remove(path_);
  AwaitUsable("0");
  EXPECT_TRUE((*file)->Get()->contains("b"));
}

TEST_F(ReloadedFileTest, ABadFileAtTheStartIsAnError) {
  EXPECT_EQ(DetailOf(Open().status()).metadata["file"], path_);
  Write("[]");
  EXPECT_EQ(DetailOf(Open().status()).metadata["place"], "tenants");
}

}  // namespace
}  // namespace slicefarm::coordinator::reloaded_file_test
