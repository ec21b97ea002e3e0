#include "common/wire/engraving/engraved_wire.h"

#include <gtest/gtest.h>

#include "common/wire/support/round_trip_test.h"

namespace slicefarm::engraved_wire_test {
namespace {

EngravedLayer Layer(size_t bytes) {
  return {.numbers = {.layer = 3, .runs = 4, .on_mm = 2.5, .first_fold_mm = {1, 2, 3}},
          .program = {.seconds = 5, .moves = 6, .least_deg = {-1, -2}, .most_deg = {7, 8}},
          .text = std::string(bytes, 'x')};
}

TEST(EngravedWire, LayoutsReturn) {
  ExpectReturns<v1::EngraveLayout>(
      EngraveLayout{7, "head", "foot", {1, 2, 3, 4, {5, 6, 7}, {8, 9, 10}, 0.5}});
}

TEST(EngravedWire, LayersReturnInPieces) {
  const std::vector<EngravedLayer> layers = {Layer(3'000'000), Layer(0), Layer(5)};
  std::vector<EngravedLayer> taken;
  int pieces = 0;
  for (const EngravedLayer& layer : layers) {
    EXPECT_TRUE(SendPieces(layer, [&](const v1::EngravedPiece& piece) {
                  ++pieces;
                  return TakePiece(piece, &taken).ok();
                }).ok());
  }
  EXPECT_EQ(taken, layers);
  EXPECT_EQ(pieces, 7);
}

TEST(EngravedWire, RefusesTextOfNoLayer) {
  v1::EngravedPiece piece;
  piece.set_text("x");
  std::vector<EngravedLayer> layers;
  ExpectMalformed(TakePiece(piece, &layers), "text");
  EXPECT_TRUE(absl::IsUnavailable(SendPieces(Layer(1), [](const auto&) { return false; })));
}

}  // namespace
}  // namespace slicefarm::engraved_wire_test
