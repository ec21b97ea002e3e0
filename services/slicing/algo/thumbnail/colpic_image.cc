#include "services/slicing/algo/thumbnail/colpic_image.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

#include "services/slicing/algo/thumbnail/rgb565.h"

namespace slicefarm::slicing {
namespace {

constexpr Rgba kBackground = {46, 51, 72, 255};
constexpr size_t kMostColours = 1024;
constexpr size_t kBankSize = 32;  ///< colours that one byte of a run can name
constexpr size_t kLongestRun = 255, kLongestShortRun = 6;
constexpr uint8_t kBankMark = 7;
constexpr int kMarkShift = 5;

int DistanceOf(uint16_t a, uint16_t b) {
  return std::abs((a >> 11) - (b >> 11)) + std::abs((a >> 5 & 63) - (b >> 5 & 63)) +
         std::abs((a & 31) - (b & 31));
}

/// Colours of a picture, and the index in the palette for each colour.
struct Palette {
  std::vector<uint16_t> colours;  ///< the most frequent colours first
  std::map<uint16_t, size_t> index;
};

Palette PaletteOf(const std::vector<uint16_t>& pixels) {
  std::map<uint16_t, int64_t> counts;
  for (const uint16_t pixel : pixels) ++counts[pixel];
  std::vector<std::pair<uint16_t, int64_t>> by_count(counts.begin(), counts.end());
  std::ranges::stable_sort(by_count,
                           [](const auto& a, const auto& b) { return a.second > b.second; });
  Palette palette;
  for (const auto& counted : by_count) {
    const uint16_t colour = counted.first;
    if (palette.colours.size() < kMostColours) {
      palette.index[colour] = palette.colours.size();
      palette.colours.push_back(colour);
      continue;
    }
    const auto nearest = std::ranges::min_element(
        palette.colours, {}, [&](uint16_t other) { return DistanceOf(colour, other); });
    palette.index[colour] = static_cast<size_t>(nearest - palette.colours.begin());
  }
  return palette;
}

/// Appends a number, the lowest byte first.
template <typename Number>
void Append(Number number, std::vector<uint8_t>& bytes) {
  for (size_t i = 0; i < sizeof(Number); ++i)
    bytes.push_back(static_cast<uint8_t>(number >> (8 * i) & 0xFF));
}

/// Returns runs of equal pixels: a byte that names the bank of colours if it changes, then the
/// length and the colour in one byte, or in two bytes for a long run.
std::vector<uint8_t> RunsOf(const std::vector<uint16_t>& pixels, const Palette& palette) {
  std::vector<uint8_t> bytes;
  size_t bank = 0;
  for (size_t i = 0; i < pixels.size();) {
    size_t end = i + 1;
    while (end < pixels.size() && end - i < kLongestRun && pixels[end] == pixels[i]) ++end;
    const size_t colour = palette.index.at(pixels[i]), run = end - i;
    if (colour / kBankSize != bank) {
      bank = colour / kBankSize;
      bytes.push_back(static_cast<uint8_t>(kBankMark << kMarkShift | bank));
    }
    const bool is_short = run <= kLongestShortRun;
    bytes.push_back(static_cast<uint8_t>((is_short ? run << kMarkShift : 0) | colour % kBankSize));
    if (!is_short) bytes.push_back(static_cast<uint8_t>(run));
    i = end;
  }
  return bytes;
}

/// Returns the bytes as text, six bits in each character.
std::string ToText(std::vector<uint8_t> bytes) {
  constexpr char kFirst = '0', kBackslash = '\\', kInstead = '~';
  do bytes.push_back(0);
  while (bytes.size() % 3 != 0);
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const uint32_t group = uint32_t{bytes[i]} << 16 | uint32_t{bytes[i + 1]} << 8 | bytes[i + 2];
    for (int shift = 18; shift >= 0; shift -= 6) {
      const char letter = static_cast<char>(kFirst + (group >> shift & 63));
      text += letter == kBackslash ? kInstead : letter;
    }
  }
  return text;
}

}  // namespace

std::string EncodeColPic(std::span<const Rgba> pixels, int32_t width, int32_t height) {
  std::vector<uint16_t> colours;
  colours.reserve(pixels.size());
  for (const Rgba& pixel : pixels) colours.push_back(ToRgb565(pixel, kBackground));
  const Palette palette = PaletteOf(colours);
  const std::vector<uint8_t> runs = RunsOf(colours, palette);
  constexpr uint8_t kVersion = 3;
  constexpr uint32_t kMark = 0x05DDC33C;
  std::vector<uint8_t> bytes = {kVersion, 0, 0, 0};
  for (const size_t number :
       {static_cast<size_t>(width), static_cast<size_t>(height), size_t{kMark},
        2 * palette.colours.size(), runs.size(), size_t{0}, size_t{0}})
    Append(static_cast<uint32_t>(number), bytes);
  for (const uint16_t colour : palette.colours) Append(colour, bytes);
  bytes.insert(bytes.end(), runs.begin(), runs.end());
  return ToText(std::move(bytes));
}

}  // namespace slicefarm::slicing
