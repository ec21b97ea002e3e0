#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared_text.h"
#include "common/geometry/polygon.h"
#include "common/model/scene/mesh.h"

namespace slicefarm::config {

/// The value of a setting, in the setting's own unit (mm, mm/s, degrees, ...).
struct Value {
  double number = 0;     ///< of numbers, flags (0, 1) and choices
  bool percent = false;  ///< `number` is a percentage of another setting
  SharedText text = {};  ///< of texts, unescaped; of lists, in canonical form

  friend bool operator==(const Value&, const Value&) = default;
};

/// Every number is a multiple of 1e-6 of its unit (lengths: 1 nm), so that a value printed and read
/// again is the same bits, and equal settings have equal texts.
double Quantise(double number);

/// "0.2", " 1e3 ", with "%" if `may_be_percent`. Errors: InvalidArgument for anything else, NaN and
/// infinities included.
absl::StatusOr<Value> ParseNumber(std::string_view text, bool may_be_percent);

/// The shortest decimal of a quantised number: "0.2", "1000", "-0.05".
std::string PrintNumber(double number);

/// `\n`, `\r` and `\\` of a config.ini's texts, to the characters and back.
std::string Unescape(std::string_view text);
std::string Escape(std::string_view text);

/// Item `index` of a list of texts, `PLA;PETG` or `"a; b";"c"`, quotes and escapes taken off; past
/// the list's end, the first.
std::string TextOfList(std::string_view list, size_t index = 0);
/// One text as such a list has it: in quotes where it must be.
std::string QuoteText(std::string_view text);

/// `0x0,250x0,250x210,0x210`, mm: a simple ring of at least three corners, which comes back
/// counter-clockwise.
absl::StatusOr<Polygon> ParseBedShape(std::string_view text);
std::string PrintBedShape(const Polygon& bed);

/// Reads areas of the bed: corners as those of ParseBedShape. Corners that come to rectangles by
/// fours are one area each, as Bambu Studio reads them; else all of them are one polygon, as
/// OrcaSlicer reads them, which may touch itself. Fewer than three corners are no area.
absl::StatusOr<std::vector<Polygon>> ParseAreas(std::string_view text);
std::string PrintAreas(const std::vector<Polygon>& areas);

/// Reads `2x0`, mm.
absl::StatusOr<Point> ParsePoint(std::string_view text);
std::string PrintPoint(const Point& point);

/// `32x32, 300x300/QOI`, pixels; empty: none. The format may be any of PrusaSlicer's; what is made
/// is QOI or JPG where it says so, else PNG. Errors: another format, more than
/// limits::kMaxThumbnails pictures, a side beyond limits::kMaxThumbnailPx.
absl::StatusOr<std::vector<ThumbnailSize>> ParseSizes(std::string_view text);
/// Whether `text`, as ParseSizes takes it, asks for no format but PNG, JPG and QOI.
bool OnlyOurFormats(std::string_view text);
std::string PrintSizes(const std::vector<ThumbnailSize>& sizes);

}  // namespace slicefarm::config
