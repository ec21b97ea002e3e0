#include "services/texture/algo/pattern/stroke_font.h"

#include "common/base/text.h"

namespace slicefarm::texture {
namespace {

struct GlyphRow {
  char letter;
  std::string_view strokes;  // points xy as digits, a blank between strokes
};

constexpr GlyphRow kGlyphs[] = {
    {' ', ""},
    {'A', "002640 1232"},
    {'B', "000636454433 3303 33424130 3000"},
    {'C', "4536160501103041"},
    {'D', "000636454130 3000"},
    {'E', "46060040 0333"},
    {'F', "460600 0333"},
    {'G', "45361605011030414323"},
    {'H', "0600 4640 0343"},
    {'I', "1636 2620 1030"},
    {'J', "4641301001"},
    {'K', "0600 460340"},
    {'L', "060040"},
    {'M', "0006234640"},
    {'N', "00064046"},
    {'O', "163645413010010516"},
    {'P', "000636454433 3303"},
    {'Q', "163645413010010516 2240"},
    {'R', "000636454433 3303 2340"},
    {'S', "4536160504133342413010 1001"},
    {'T', "0646 2620"},
    {'U', "060110304146"},
    {'V', "062046"},
    {'W', "0610233046"},
    {'X', "0640 0046"},
    {'Y', "062346 2320"},
    {'Z', "06460040"},
    {'0', "163645413010010516 0145"},
    {'1', "052620 1030"},
    {'2', "0516364544000040"},
    {'3', "064623334241301001"},
    {'4', "3036360242"},
    {'5', "460603334241301001"},
    {'6', "4536160501103041423303"},
    {'7', "064610"},
    {'8', "133344453616050413 130201103041 4233"},
    {'9', "0110304145361605041343"},
    {'-', "0343"},
    {'+', "0343 2125"},
    {'.', "2021"},
    {'!', "2622 2120"},
    {'/', "0046"},
};

const GlyphRow* FindGlyph(char c) {
  for (const GlyphRow& row : kGlyphs)
    if (row.letter == c) return &row;
  return nullptr;
}

}  // namespace

bool HasGlyph(char c) { return FindGlyph(c) != nullptr; }

std::vector<Stroke> GlyphOf(char c) {
  std::vector<Stroke> strokes;
  for (const std::string_view digits : Split(FindGlyph(c)->strokes, " ")) {
    Stroke stroke;
    for (size_t i = 0; i + 1 < digits.size(); i += 2)
      stroke.push_back(Eigen::Vector2d(digits[i] - '0', digits[i + 1] - '0'));
    if (!stroke.empty()) strokes.push_back(std::move(stroke));
  }
  return strokes;
}

}  // namespace slicefarm::texture
