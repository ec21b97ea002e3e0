#include "services/slicing/algo/thumbnail/btt_image.h"

#include <algorithm>
#include <iterator>

#include "services/slicing/algo/thumbnail/rgb565.h"

namespace slicefarm::slicing {
namespace {

/// Nearly black colours that the firmware shows as coloured dots.
constexpr uint16_t kAsBlack[] = {0x0020, 0x0841, 0x0861};

void AppendHex(uint32_t value, std::string& text) {
  constexpr char kDigits[] = "0123456789abcdef";
  for (int shift = 12; shift >= 0; shift -= 4) text += kDigits[value >> shift & 0xF];
}

}  // namespace

std::string EncodeBtt(std::span<const Rgba> pixels, int32_t width, int32_t height) {
  constexpr std::string_view kLineEnd = "\r\n";
  std::string text = ";";
  AppendHex(static_cast<uint32_t>(width), text);
  AppendHex(static_cast<uint32_t>(height), text);
  text += kLineEnd;
  for (size_t i = 0; i < pixels.size(); ++i) {
    if (i % static_cast<size_t>(width) == 0) text += ';';
    const uint16_t colour = ToRgb565(pixels[i], {0, 0, 0, 255});
    const bool black = std::ranges::find(kAsBlack, colour) != std::end(kAsBlack);
    AppendHex(black ? 0 : colour, text);
    if ((i + 1) % static_cast<size_t>(width) == 0) text += kLineEnd;
  }
  return text;
}

}  // namespace slicefarm::slicing
