#include "services/slicing/sandbox/reader_protocol.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/base/error.h"

namespace slicefarm::slicing {
namespace {

Reason ReasonOf(const absl::Status& status) { return DetailOf(status).reason; }

AnswerHead MeshHead(uint64_t positions, uint64_t triangles) {
  return {.build_id = ThisBuild(), .positions = positions, .triangles = triangles};
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
  constexpr int64_t kFileBytes = 1'000;
  EXPECT_TRUE(CheckHead(MeshHead(500, 500), kFileBytes).ok());
  EXPECT_TRUE(CheckHead(MeshHead(30, 10), kFileBytes).ok());
  for (const AnswerHead& head :
       {MeshHead(31, 10), MeshHead(0, 10), MeshHead(10, 0), MeshHead(500, 501), MeshHead(501, 500),
        MeshHead(3, UINT64_MAX / 3 + 2)})
    EXPECT_EQ(ReasonOf(CheckHead(head, kFileBytes)), Reason::kMeshReaderCrashed);
  EXPECT_FALSE(CheckHead(MeshHead(3, 20'000'001), INT64_MAX).ok());
}

TEST(ReaderProtocol, HeadsOfAnotherKindOrBuildAreRefused) {
  AnswerHead head = MeshHead(3, 1);
  head.error_bytes = 1;
  EXPECT_FALSE(CheckHead(head, 1'000).ok());
  head.kind = AnswerKind::kError;
  EXPECT_TRUE(CheckHead(head, 1'000).ok());
  head.error_bytes = 1 << 20;
  EXPECT_FALSE(CheckHead(head, 1'000).ok());
  head = MeshHead(3, 1);
  head.build_id[0] = '-';
  EXPECT_EQ(ReasonOf(CheckHead(head, 1'000)), Reason::kBuildMismatch);
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
  for (double Position::*axis : {&Position::x, &Position::y, &Position::z}) {
    RawMesh bad = good;
    bad.positions[1].*axis = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(ReasonOf(CheckMesh(bad, 9)), Reason::kMeshReaderCrashed);
  }
}

TEST(ReaderLimits, GrowWithTheFileUpToWhatAnyMeshTakes) {
  constexpr int64_t kMib = 1 << 20;
  EXPECT_EQ(ReaderLimitsFor(0), (ReaderLimits{64 * kMib, 10}));
  EXPECT_EQ(ReaderLimitsFor(10 * kMib), (ReaderLimits{(64 + 10 + 320) * kMib, 11}));
  EXPECT_EQ(ReaderLimitsFor(1000 * kMib), (ReaderLimits{(64 + 1000 + 8192) * kMib, 110}));
}

}  // namespace
}  // namespace slicefarm::slicing
