#include "services/slicing/sandbox/reader_protocol.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/base/error.h"

namespace slicefarm::slicing::reader_protocol_test {
namespace {

Reason ReasonOf(const absl::Status& status) { return DetailOf(status).reason; }

AnswerHead ContentsHead(uint64_t project_bytes, uint64_t meshes) {
  return {.build_id = ThisBuild(), .project_bytes = project_bytes, .meshes = meshes};
}

TEST(ReaderProtocol, AnErrorComesBackAsItWas) {
  const absl::Status error = MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshTruncated,
                                       "too short", {{"got", "1"}, {"limit", ""}});
  const absl::Status back = DecodeError(EncodeError(error));
  EXPECT_EQ(back.code(), error.code());
  EXPECT_EQ(back.message(), error.message());
  EXPECT_EQ(DetailOf(back).reason, DetailOf(error).reason);
  EXPECT_EQ(DetailOf(back).metadata, DetailOf(error).metadata);
}

TEST(ReaderProtocol, OnlyErrorsOfReadingAreBelieved) {
  for (const std::string text : {"", "MESH_EMPTY", "UNAVAILABLE", "NO_SUCH_REASON"})
    EXPECT_EQ(ReasonOf(DecodeError(text)), Reason::kMeshReaderCrashed) << text;
  EXPECT_EQ(ReasonOf(DecodeError(std::string("STORE_FAILED\0x", 14))), Reason::kMeshReaderCrashed);
  const absl::Status odd = DecodeError(std::string("MESH_EMPTY\0x\0key", 16));
  EXPECT_EQ(ReasonOf(odd), Reason::kMeshEmpty);
  EXPECT_TRUE(DetailOf(odd).metadata.empty());
}

TEST(ReaderProtocol, CountsAreBoundByTheFile) {
  constexpr Request kRequest = {.text_bytes = 1'000};
  EXPECT_TRUE(MeshHeads(kRequest).Check({1'000, 1'000}).ok());
  EXPECT_TRUE(MeshHeads(kRequest).Check({30, 10}).ok());
  EXPECT_TRUE(MeshHeads(kRequest).Check({0, 0}).ok());
  for (const MeshHead& head : std::initializer_list<MeshHead>{
           {31, 10}, {0, 10}, {10, 0}, {1'000, 1'001}, {1'001, 1'000}, {3, UINT64_MAX / 3 + 2}})
    EXPECT_EQ(ReasonOf(MeshHeads(kRequest).Check(head)), Reason::kMeshReaderCrashed);
  EXPECT_FALSE(MeshHeads({.text_bytes = INT64_MAX}).Check({3, 20'000'001}).ok());
}

TEST(ReaderProtocol, CountsOfAllMeshesAreBoundTogether) {
  MeshHeads heads({.text_bytes = 1'000});
  EXPECT_TRUE(heads.Check({600, 600}).ok());
  EXPECT_TRUE(heads.Check({400, 200}).ok());
  EXPECT_FALSE(heads.Check({3, 1}).ok());
}

TEST(ReaderProtocol, AnArchiveMayStandForMoreText) {
  EXPECT_EQ(RequestOf("v 1 2 3", ReadDepth::kMeshes).text_bytes, 7);
  const std::string archive = "PK\x03\x04" + std::string(996, 'x');
  EXPECT_EQ(RequestOf(archive, ReadDepth::kMeshes).text_bytes, (1 << 20) + 200'000);
}

TEST(ReaderProtocol, HeadsOfAnotherKindOrBuildAreRefused) {
  constexpr Request kRequest = {.text_bytes = 1'000};
  constexpr Request kStructure = {.text_bytes = 1'000, .depth = ReadDepth::kStructure};
  EXPECT_TRUE(CheckHead(ContentsHead(100, 1), kRequest).ok());
  EXPECT_FALSE(CheckHead(ContentsHead(100, 0), kRequest).ok());
  EXPECT_TRUE(CheckHead(ContentsHead(100, 0), kStructure).ok());
  EXPECT_FALSE(CheckHead(ContentsHead(100, 1), kStructure).ok());
  EXPECT_FALSE(CheckHead(ContentsHead(0, 1), kRequest).ok());
  EXPECT_FALSE(CheckHead(ContentsHead(1 << 30, 1), kRequest).ok());
  EXPECT_FALSE(CheckHead(ContentsHead(100, UINT64_MAX), kRequest).ok());
  AnswerHead head = ContentsHead(100, 1);
  head.error_bytes = 1;
  EXPECT_FALSE(CheckHead(head, kRequest).ok());
  head.kind = AnswerKind::kError;
  EXPECT_TRUE(CheckHead(head, kRequest).ok());
  head.error_bytes = 1 << 20;
  EXPECT_FALSE(CheckHead(head, kRequest).ok());
  head = ContentsHead(100, 1);
  head.build_id[0] = '-';
  EXPECT_EQ(ReasonOf(CheckHead(head, kRequest)), Reason::kBuildMismatch);
}

TEST(ReaderProtocol, AMeshHasToKeepWhatItPromises) {
  const RawMesh good = {{{0, 0, 0}, {9, 0, 0}, {0, -9, 0}}, {{0, 1, 2}}};
  EXPECT_TRUE(CheckMesh(good, 9).ok());
  EXPECT_FALSE(CheckMesh(good, 8.9).ok());
  for (size_t corner = 0; corner < 3; ++corner) {
    RawMesh bad = good;
    bad.triangles[0][corner] = 3;
    EXPECT_FALSE(CheckMesh(bad, 9).ok()) << corner;
  }
  for (const int axis : {0, 1, 2}) {
    RawMesh bad = good;
    bad.positions[1][axis] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(ReasonOf(CheckMesh(bad, 9)), Reason::kMeshReaderCrashed);
  }
}

TEST(ReaderLimits, GrowWithTheFileUpToWhatAnyMeshTakes) {
  constexpr int64_t kMib = 1 << 20;
  const auto of = [](int64_t bytes) {
    return ReaderLimitsFor(std::string(static_cast<size_t>(bytes), 'v'));
  };
  EXPECT_EQ(of(0), (ReaderLimits{64 * kMib, 10}));
  EXPECT_EQ(of(10 * kMib), (ReaderLimits{(64 + 10 + 320) * kMib, 11}));
  EXPECT_EQ(of(1000 * kMib), (ReaderLimits{(64 + 1000 + 8192) * kMib, 110}));
}

TEST(ReaderLimits, AreForTheTextOfAnArchive) {
  constexpr int64_t kMib = 1 << 20;
  std::string archive(kMib, 'x');
  archive.replace(0, 4, "PK\x03\x04");
  EXPECT_EQ(ReaderLimitsFor(archive), (ReaderLimits{(64 + 1 + 256 + 80) * kMib, 15}));
}

}  // namespace
}  // namespace slicefarm::slicing::reader_protocol_test
