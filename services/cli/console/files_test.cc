#include "services/cli/console/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"

namespace slicefarm::cli::files_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class Files : public testing::Test {
 protected:
  std::string Path(const std::string& name) const { return folder_.path() + "/" + name; }

  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

  /// Returns the content of a file without registering it as an input.
  std::string Content(const std::string& name) const {
    std::ifstream file(Path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const TempDirectory folder_;
};

TEST_F(Files, ComeBackAsTheyWere) {
  for (const size_t size : {0, 1, 4096, (1 << 20) - 1, 1 << 20, (1 << 20) + 1, 3'000'000}) {
    std::string bytes(size, 'x');
    if (size > 2) bytes[1] = '\0';
    const std::string path = Path(std::to_string(size));
    ASSERT_TRUE(WriteFile(path, bytes).ok());
    const auto read = ReadFile(path, 1 << 30);
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(*read, bytes);
  }
}

TEST_F(Files, AreReadUpToTheLimit) {
  ASSERT_TRUE(WriteFile(Path("a"), "12345").ok());
  EXPECT_TRUE(ReadFile(Path("a"), 5).ok());
  const auto read = ReadFile(Path("a"), 4);
  EXPECT_EQ(DetailOf(read.status()).reason, Reason::kRequestTooLarge);
  EXPECT_EQ(DetailOf(read.status()).metadata.at("limit"), "4");
}

TEST_F(Files, SayWhyTheyCannotBeRead) {
  EXPECT_THAT(std::string(ReadFile(Path("none"), 10).status().message()),
              HasSubstr("No such file or directory"));
  EXPECT_THAT(std::string(ReadFile(folder_.path(), 10).status().message()),
              HasSubstr("Is a directory"));
}

TEST_F(Files, AreNotThereBeforeTheyAreComplete) {
  {
    auto file = OutputFile::Create(Path("a"));
    ASSERT_TRUE(file.ok());
    ASSERT_TRUE(file->Write("half").ok());
    EXPECT_FALSE(std::filesystem::exists(Path("a")));
  }
  EXPECT_THAT(Names(), IsEmpty());
}

TEST_F(Files, KeepTheOldContentUntilTheNewOneIsComplete) {
  ASSERT_TRUE(WriteFile(Path("a"), "old").ok());
  {
    auto file = OutputFile::Create(Path("a"));
    ASSERT_TRUE(file->Write("new").ok());
    EXPECT_EQ(Content("a"), "old");
  }
  EXPECT_EQ(Content("a"), "old");
  ASSERT_TRUE(WriteFile(Path("a"), "new").ok());
  EXPECT_EQ(Content("a"), "new");
  EXPECT_THAT(Names(), UnorderedElementsAre("a"));
}

TEST_F(Files, NeverReplaceWhatWasRead) {
  ASSERT_TRUE(WriteFile(Path("a"), "read").ok());
  ASSERT_TRUE(ReadFile(Path("a"), 10).ok());
  std::filesystem::create_symlink(Path("a"), Path("link"));
  std::filesystem::create_hard_link(Path("a"), Path("hard"));
  for (const char* name : {"a", "./a", "link", "hard"}) {
    const absl::Status refused = WriteFile(Path(name), "other");
    EXPECT_EQ(DetailOf(refused).reason, Reason::kRequestMalformed) << name;
    EXPECT_EQ(CheckWritable(Path(name)), refused) << name;
    EXPECT_EQ(Content(name), "read");
  }
  // A new file with the same name is another file.
  std::filesystem::remove(Path("a"));
  std::filesystem::remove(Path("link"));
  std::filesystem::remove(Path("hard"));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(WriteFile(Path("a"), "new").ok());
}

TEST_F(Files, StayBehindTheirLinks) {
  ASSERT_TRUE(WriteFile(Path("real"), "old").ok());
  std::filesystem::create_symlink(Path("real"), Path("link"));
  ASSERT_TRUE(WriteFile(Path("link"), "new").ok());
  EXPECT_TRUE(std::filesystem::is_symlink(Path("link")));
  EXPECT_EQ(*ReadFile(Path("real"), 10), "new");
}

TEST_F(Files, HaveTheUsualMode) {
  ASSERT_TRUE(WriteFile(Path("a"), "").ok());
  struct stat info = {};
  ASSERT_EQ(stat(Path("a").c_str(), &info), 0);
  const mode_t mask = umask(0);
  umask(mask);
  EXPECT_EQ(info.st_mode & 0777, 0666 & ~mask);
}

TEST_F(Files, WriteToDevicesInPlace) {
  EXPECT_TRUE(WriteFile("/dev/null", "bytes").ok());
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(Files, SayWhyTheyCannotBeWritten) {
  const absl::Status missing = WriteFile(Path("none/a"), "");
  EXPECT_TRUE(absl::IsDataLoss(missing));
  EXPECT_THAT(std::string(missing.message()), HasSubstr("No such file or directory"));
  EXPECT_THAT(std::string(WriteFile(folder_.path(), "").message()), HasSubstr("directory"));
  EXPECT_THAT(std::string(WriteFile("/dev/full", std::string(1 << 20, 'x')).message()),
              HasSubstr("No space left on device"));
}

/// Models a process that ends at once, with a file half written.
TEST_F(Files, PartialOnesGoWithTheProcess) {
  ASSERT_TRUE(WriteFile(Path("whole"), "1").ok());
  EXPECT_EXIT(
      {
        auto file = OutputFile::Create(Path("half"));
        if (!file.ok() || !file->Write("12").ok() || Names().size() != 2) _exit(1);
        RemovePartialFiles();
        _exit(7);
      },
      testing::ExitedWithCode(7), "");
  EXPECT_THAT(Names(), UnorderedElementsAre("whole"));
}

}  // namespace
}  // namespace slicefarm::cli::files_test
