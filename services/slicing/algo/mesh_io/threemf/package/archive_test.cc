#include "services/slicing/algo/mesh_io/threemf/package/archive.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"

namespace slicefarm::slicing::threemf::archive_test {
namespace {

Reason ReasonOf(const absl::Status& status) { return DetailOf(status).reason; }

/// Opens an archive and reads all of its entries.
absl::Status ReadAll(const std::string& bytes) {
  const auto archive = Archive::Open(bytes);
  if (!archive.ok()) return archive.status();
  for (const ArchiveEntry& entry : archive->entries())
    if (const auto text = archive->ReadAll(entry); !text.ok()) return text.status();
  return absl::OkStatus();
}

TEST(Archive, GivesWhatIsInIt) {
  for (const zip_int32_t method : {ZIP_CM_STORE, ZIP_CM_DEFLATE}) {
    const std::string bytes =
        Zipped({{"3D/A.model", "one"}, {"b\\c", std::string(100'000, 'x')}}, {.method = method});
    const auto archive = Archive::Open(bytes);
    ASSERT_TRUE(archive.ok()) << archive.status();
    ASSERT_EQ(archive->entries().size(), 2u);
    ASSERT_NE(archive->Find("/3d/a.MODEL"), nullptr);
    EXPECT_EQ(*archive->ReadAll(*archive->Find("3D/A.model")), "one");
    EXPECT_EQ(archive->ReadAll(*archive->Find("B/C"))->size(), 100'000u);
    EXPECT_EQ(archive->Find("3D"), nullptr);
  }
}

TEST(Archive, RefusesNamesThatLeadOut) {
  for (const std::string name : {"../a", "a/../../b", "..", "a\\..\\b", "/a", "\\a", "C:/a"}) {
    const absl::Status status = ReadAll(Zipped({{name, "x"}}));
    EXPECT_EQ(ReasonOf(status), Reason::kMeshMalformed) << name << status;
    EXPECT_NE(DetailOf(status).metadata["part"], "") << name;
  }
  EXPECT_TRUE(ReadAll(Zipped({{"a..b/..c", "x"}})).ok());
  EXPECT_EQ(ReasonOf(ReadAll(Zipped({{"a\nb", "x"}}))), Reason::kMeshMalformed);
}

TEST(Archive, RefusesDuplicates) {
  const std::string twice =
      Replaced(Zipped({{"a/b.txt", "1"}, {"a/c.txt", "2"}}), "c.txt", "b.txt");
  EXPECT_EQ(ReasonOf(ReadAll(twice)), Reason::kMeshMalformed);
  EXPECT_EQ(ReasonOf(ReadAll(Zipped({{"a/b", "1"}, {"A/B", "2"}}))), Reason::kMeshMalformed);
}

TEST(Archive, RefusesWhatExpandsTooFar) {
  const absl::Status bomb = ReadAll(Zipped({{"blanks", std::string(8 << 20, ' ')}}));
  EXPECT_EQ(ReasonOf(bomb), Reason::kMeshTooLarge) << bomb;
  EXPECT_EQ(DetailOf(bomb).metadata["got"], std::to_string(8 << 20));
  EXPECT_TRUE(ReadAll(Zipped({{"blanks", std::string(1 << 20, ' ')}})).ok());
  Files many;
  for (int i = 0; i < 20; ++i) many.emplace_back(std::to_string(i), std::string(1 << 20, ' '));
  EXPECT_EQ(ReasonOf(ReadAll(Zipped(many))), Reason::kMeshTooLarge) << "all together";
}

TEST(Archive, RefusesTooManyEntries) {
  Files files;
  for (int i = 0; i < 1001; ++i) files.emplace_back(std::to_string(i), "");
  const absl::Status status = ReadAll(Zipped(files));
  EXPECT_EQ(ReasonOf(status), Reason::kMeshTooLarge) << status;
  EXPECT_EQ(DetailOf(status).metadata["limit"], "1000");
}

TEST(Archive, RefusesEncryptedEntries) {
  const absl::Status status = ReadAll(Zipped({{"a", "secret"}}, {.encrypted = true}));
  EXPECT_EQ(ReasonOf(status), Reason::kMeshMalformed) << status;
}

/// The directory states a size that differs from the size of the data.
TEST(Archive, RefusesLyingSizes) {
  const std::string good = Zipped({{"a", std::string(1000, 'x')}}, {.method = ZIP_CM_STORE});
  const std::string size("\xe8\x03\x00\x00", 4);
  for (const std::string& lie :
       {std::string("\xe7\x03\x00\x00", 4), std::string("\xe9\x03\x00\x00", 4),
        std::string("\xff\xff\xff\xff", 4)}) {
    const absl::Status status = ReadAll(Replaced(good, size, lie));
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  }
  const std::string packed = Zipped({{"a", std::string(1000, 'x')}});
  for (const std::string& lie :
       {std::string("\xe7\x03\x00\x00", 4), std::string("\xe9\x03\x00\x00", 4)})
    EXPECT_TRUE(absl::IsInvalidArgument(ReadAll(Replaced(packed, size, lie))));
}

TEST(Archive, RefusesWrongChecksums) {
  std::string bytes = Zipped({{"a", "some text"}}, {.method = ZIP_CM_STORE});
  const absl::Status status = ReadAll(Replaced(bytes, "some text", "some test"));
  EXPECT_EQ(ReasonOf(status), Reason::kMeshMalformed) << status;
}

TEST(Archive, EveryCutIsAnError) {
  const std::string good = Zipped({{"a", "some text"}, {"b", std::string(500, 'y')}});
  for (size_t size = 1; size < good.size(); ++size) {
    const absl::Status status = ReadAll(good.substr(0, size));
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << size << status;
  }
  EXPECT_EQ(ReasonOf(ReadAll(good.substr(0, good.size() / 2))), Reason::kMeshTruncated);
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::archive_test
