#include "services/slicing/algo/thumbnail/btt_image.h"

#include <gtest/gtest.h>

#include <vector>

namespace slicefarm::slicing::btt_image_test {
namespace {

TEST(EncodeBtt, RowsOfHexadecimalColours) {
  const std::vector<Rgba> pixels = {
      {255, 255, 255, 255}, {255, 0, 0, 255}, {0, 0, 255, 255}, {0, 255, 0, 0}};
  EXPECT_EQ(EncodeBtt(pixels, 2, 2), ";00020002\r\n;fffff800\r\n;001f0000\r\n");
  EXPECT_EQ(EncodeBtt(std::vector<Rgba>{{0, 4, 0, 255}}, 1, 1), ";00010001\r\n;0000\r\n")
      << "nearly black is black";
}

}  // namespace
}  // namespace slicefarm::slicing::btt_image_test
