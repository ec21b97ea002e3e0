#include "services/cli/calibration/solid_builder.h"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace slicefarm::cli {
namespace {

// Shares of the height of a text.
constexpr float kCharacterWidth = 0.56F, kGap = 0.22F, kStroke = 0.18F;
constexpr float kOverlapMm = 0.3F;  ///< depth of text within the surface that carries it

/// Rectangle within a character: x to the right, y up, as shares of the text's height.
struct Stroke {
  float left, bottom, right, top;
};

/// Strokes of a digit display: top, middle and bottom lines, and the lines at both sides.
constexpr float kHalf = 0.5F, kHalfStroke = kStroke / 2;
constexpr Stroke kBars[] = {
    {0, 1 - kStroke, kCharacterWidth, 1},                                   // top
    {0, kHalf - kHalfStroke, kCharacterWidth, kHalf + kHalfStroke},         // middle
    {0, 0, kCharacterWidth, kStroke},                                       // bottom
    {0, kHalf - kHalfStroke, kStroke, 1},                                   // upper left
    {kCharacterWidth - kStroke, kHalf - kHalfStroke, kCharacterWidth, 1},   // upper right
    {0, 0, kStroke, kHalf + kHalfStroke},                                   // lower left
    {kCharacterWidth - kStroke, 0, kCharacterWidth, kHalf + kHalfStroke}};  // lower right
/// Bars of each digit: bit i is kBars[i].
constexpr uint8_t kBarsOfDigit[] = {0b1111101, 0b1010000, 0b0110111, 0b1010111, 0b1011010,
                                    0b1001111, 0b1101111, 0b1010001, 0b1111111, 0b1011111};

std::vector<Stroke> StrokesOf(char c) {
  constexpr float kMiddle = kCharacterWidth / 2;
  if (c == '.') return {{kMiddle - kStroke, 0, kMiddle + kHalfStroke, kStroke * 1.5F}};
  std::vector<Stroke> strokes;
  if (c == '-' || c == '+') strokes.push_back(kBars[1]);
  if (c == '+')
    strokes.push_back(
        {kMiddle - kHalfStroke, kHalf - kMiddle, kMiddle + kHalfStroke, kHalf + kMiddle});
  if (c < '0' || c > '9') return strokes;
  for (size_t i = 0; i < std::size(kBars); ++i)
    if ((kBarsOfDigit[c - '0'] >> i & 1) != 0) strokes.push_back(kBars[i]);
  return strokes;
}

/// Returns the strokes of a text of height 1.
std::vector<Stroke> StrokesOf(std::string_view text) {
  std::vector<Stroke> strokes;
  float x = 0;
  for (const char c : text) {
    for (const Stroke& each : StrokesOf(c))
      strokes.push_back({each.left + x, each.bottom, each.right + x, each.top});
    x += kCharacterWidth + kGap;
  }
  return strokes;
}

void AppendLittleEndian(uint32_t value, int bytes, std::string& out) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> 8 * i & 0xff);
}

}  // namespace

float TextWidth(std::string_view text, float height) {
  if (text.empty()) return 0;
  return height * (static_cast<float>(text.size()) * (kCharacterWidth + kGap) - kGap);
}

void SolidBuilder::AddPrism(const std::vector<std::array<float, 2>>& outline, int axis, float low,
                            float high) {
  // Slightly different lengths: edges of two solids at the same place would count as a defect.
  constexpr int kLengths = 32;
  constexpr float kUnlikeMm = 0.001F;
  const float less = kUnlikeMm * static_cast<float>(solids_++ % kLengths);
  low += less;
  high -= less;
  const auto at = [&](size_t corner, float along) {
    const auto& [u, v] = outline[corner % outline.size()];
    if (axis == 0) return SolidPoint{along, u, v};
    if (axis == 1) return SolidPoint{u, along, v};
    return SolidPoint{u, v, along};
  };
  // The axes x z are a left-handed pair around y.
  const bool flip = axis == 1;
  const auto add = [&](const SolidPoint& a, const SolidPoint& b, const SolidPoint& c) {
    faces_.push_back(flip ? Face{a, c, b} : Face{a, b, c});
  };
  for (size_t i = 0; i < outline.size(); ++i) {
    add(at(i, low), at(i + 1, low), at(i + 1, high));
    add(at(i, low), at(i + 1, high), at(i, high));
    if (i == 0 || i + 1 == outline.size()) continue;
    add(at(0, high), at(i, high), at(i + 1, high));
    add(at(0, low), at(i + 1, low), at(i, low));
  }
}

void SolidBuilder::AddBox(const SolidPoint& low, const SolidPoint& high) {
  AddPrism({{{low[0], low[1]}, {high[0], low[1]}, {high[0], high[1]}, {low[0], high[1]}}}, 2,
           low[2], high[2]);
}

void SolidBuilder::AddTextOnFront(std::string_view text, const SolidPoint& corner, float height,
                                  float depth) {
  for (const Stroke& stroke : StrokesOf(text))
    AddBox(
        {corner[0] + stroke.left * height, corner[1] - depth, corner[2] + stroke.bottom * height},
        {corner[0] + stroke.right * height, corner[1] + kOverlapMm,
         corner[2] + stroke.top * height});
}

void SolidBuilder::AddTextOnTop(std::string_view text, const SolidPoint& corner, float height,
                                float depth) {
  for (const Stroke& stroke : StrokesOf(text))
    AddBox({corner[0] + stroke.left * height, corner[1] + stroke.bottom * height,
            corner[2] - kOverlapMm},
           {corner[0] + stroke.right * height, corner[1] + stroke.top * height, corner[2] + depth});
}

std::string SolidBuilder::Stl() const {
  constexpr size_t kHeader = 80;
  std::string stl(kHeader, ' ');
  AppendLittleEndian(static_cast<uint32_t>(faces_.size()), 4, stl);
  for (const Face& face : faces_) {
    for (int i = 0; i < 3; ++i)
      AppendLittleEndian(0, 4, stl);  // the normal follows from the corners
    for (const SolidPoint* corner : {&face.a, &face.b, &face.c})
      for (const float coordinate : *corner)
        AppendLittleEndian(std::bit_cast<uint32_t>(coordinate), 4, stl);
    AppendLittleEndian(0, 2, stl);
  }
  return stl;
}

}  // namespace slicefarm::cli
