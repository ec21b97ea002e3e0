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

/// Value of a setting, in the setting's own unit (mm, mm/s, degrees, ...).
struct Value {
  double number = 0;     ///< value of a number, a flag (0, 1) or a choice
  bool percent = false;  ///< true if `number` is a percentage of another setting
  SharedText text = {};  ///< unescaped text, or a list in canonical form

  friend bool operator==(const Value&, const Value&) = default;
};

/// Rounds a number to a multiple of 1e-6 of its unit (lengths: 1 nm). All numbers are rounded.
/// Therefore a value has the same bits after printing and parsing, and equal settings have equal
/// texts.
double Quantise(double number);

/// Parses a number such as "0.2" or " 1e3 ", with "%" if `may_be_percent`. Errors: InvalidArgument
/// for any other text, and for NaN and infinities.
absl::StatusOr<Value> ParseNumber(std::string_view text, bool may_be_percent);

/// Returns the shortest decimal text of a quantised number: "0.2", "1000", "-0.05".
std::string PrintNumber(double number);

/// Returns a text of a config.ini with the escapes `\n`, `\r` and `\\` replaced by characters.
std::string Unescape(std::string_view text);
/// Returns a text with these characters replaced by escapes, the inverse of Unescape.
std::string Escape(std::string_view text);

/// Returns item `index` of a list of texts, such as `PLA;PETG` or `"a; b";"c"`, without quotes and
/// escapes. Returns the first item if `index` is past the end.
std::string TextOfList(std::string_view list, size_t index = 0);
/// Returns a text in the form of an item of a list (TextOfList), in quotes if necessary.
std::string QuoteText(std::string_view text);

/// Parses a bed shape in mm, such as `0x0,250x0,250x210,0x210`: a simple ring of at least three
/// corners. The result is counter-clockwise.
absl::StatusOr<Polygon> ParseBedShape(std::string_view text);
std::string PrintBedShape(const Polygon& bed);

/// Parses areas of the bed, with corners in the form of ParseBedShape. If each group of four
/// corners is a rectangle, each group is one area, as in Bambu Studio. Otherwise all corners form
/// one polygon, as in OrcaSlicer; it may touch itself. Fewer than three corners are no area.
absl::StatusOr<std::vector<Polygon>> ParseAreas(std::string_view text);
std::string PrintAreas(const std::vector<Polygon>& areas);

/// Parses a point in mm, such as `2x0`.
absl::StatusOr<Point> ParsePoint(std::string_view text);
std::string PrintPoint(const Point& point);

/// Parses picture sizes in pixels, such as `32x32, 300x300/QOI`; an empty text gives no sizes. The
/// formats are PNG, QOI, JPG, BTT_TFT and COLPIC. Errors: unknown format, more than
/// limits::kMaxThumbnails pictures, a side beyond limits::kMaxThumbnailPx.
absl::StatusOr<std::vector<ThumbnailSize>> ParseSizes(std::string_view text);
std::string PrintSizes(const std::vector<ThumbnailSize>& sizes);

}  // namespace slicefarm::config
