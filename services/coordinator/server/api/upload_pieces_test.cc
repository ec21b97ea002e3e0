#include "services/coordinator/server/api/upload_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace slicefarm::coordinator::upload_pieces_test {
namespace {

struct Kept {
  int64_t offset = 0;
  int64_t bytes = 0;

  friend bool operator==(const Kept&, const Kept&) = default;
};

struct Store {
  UploadPieces::Keep Keep() {
    return [this](int64_t offset, std::string_view bytes) -> absl::StatusOr<BlobStatus> {
      kept.push_back({offset, std::ssize(bytes)});
      content += bytes;
      return BlobStatus{offset + std::ssize(bytes), false};
    };
  }

  std::vector<Kept> kept;
  std::string content;
};

std::string Content(int64_t bytes) {
  std::string content;
  for (int64_t i = 0; i < bytes; ++i) content += static_cast<char>(i * 131 >> 3);
  return content;
}

TEST(UploadPieces, AreOfTheStoresSizeWhateverTheChunksAre) {
  const std::string content = Content(2 * kBlobPieceBytes + 5);
  for (const int64_t chunk : {int64_t{1}, int64_t{4099}, int64_t{1} << 16, 2 * kBlobPieceBytes}) {
    Store store;
    UploadPieces pieces(0, store.Keep());
    for (size_t at = 0; at < content.size(); at += chunk) {
      ASSERT_TRUE(pieces.Add(std::string_view(content).substr(at, chunk)).ok());
      ASSERT_LE(pieces.offset() - pieces.status().committed_size, kBlobPieceBytes);
    }
    ASSERT_TRUE(pieces.KeepRest().ok());
    EXPECT_EQ(store.content, content) << chunk;
    EXPECT_LE(store.kept.size(), 4u) << chunk;
  }
}

TEST(UploadPieces, GoOnAtTheNextBoundary) {
  Store store;
  UploadPieces pieces(kBlobPieceBytes - 10, store.Keep());
  ASSERT_TRUE(pieces.Add("1234").ok());
  ASSERT_TRUE(pieces.Add("5678").ok());
  ASSERT_TRUE(pieces.Add("90ab").ok());
  ASSERT_TRUE(pieces.KeepRest().ok());
  EXPECT_THAT(store.kept,
              testing::ElementsAre(Kept{kBlobPieceBytes - 10, 4}, Kept{kBlobPieceBytes - 6, 6},
                                   Kept{kBlobPieceBytes, 2}));
}

TEST(UploadPieces, AnEmptyOneIsBegunAsWell) {
  Store store;
  UploadPieces pieces(0, store.Keep());
  ASSERT_TRUE(pieces.Add("").ok());
  EXPECT_THAT(store.kept, testing::ElementsAre(Kept{0, 0}));
}

TEST(UploadPieces, WhatCannotBeKeptEndsThem) {
  UploadPieces pieces(0, [](int64_t, std::string_view) -> absl::StatusOr<BlobStatus> {
    return absl::UnavailableError("away");
  });
  EXPECT_TRUE(absl::IsUnavailable(pieces.Add("x")));
}

}  // namespace
}  // namespace slicefarm::coordinator::upload_pieces_test
