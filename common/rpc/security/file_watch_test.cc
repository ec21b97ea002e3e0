#include "common/rpc/security/file_watch.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <fstream>
#include <mutex>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"

namespace slicefarm::rpc::file_watch_test {
namespace {

class FileWatchTest : public testing::Test {
 protected:
  void Write(const std::string& text) {
    std::ofstream(path_ + ".new") << text;
    std::filesystem::rename(path_ + ".new", path_);
  }

  std::string Reported() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !reported_.empty(); });
    std::string text = reported_.front();
    reported_.pop_front();
    return text;
  }

  void Report(const absl::StatusOr<std::string>& text) {
    const std::lock_guard lock(mutex_);
    reported_.push_back(text.ok() ? *text
                                  : std::string(ReasonName(DetailOf(text.status()).reason)));
    changed_.notify_one();
  }

  TempDirectory directory_;
  const std::string path_ = directory_.path() + "/file";
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> reported_;
};

TEST_F(FileWatchTest, TellsEachOtherText) {
  Write("one");
  const FileWatch watch(
      path_, "one", [this](const auto& text) { Report(text); }, std::chrono::milliseconds(1));
  Write("two");
  EXPECT_EQ(Reported(), "two");
  std::filesystem::remove(path_);
  EXPECT_EQ(Reported(), "REQUEST_MALFORMED");
  Write("two");
  EXPECT_EQ(Reported(), "two");
}

TEST_F(FileWatchTest, FilesThatCannotBeReadAreNamed) {
  const absl::Status status = ReadTextFile(path_).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(status).metadata["file"], path_);
  std::filesystem::create_directory(path_);
  EXPECT_FALSE(ReadTextFile(path_).ok());
}

}  // namespace
}  // namespace slicefarm::rpc::file_watch_test
