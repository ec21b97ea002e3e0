#include "common/config/table/value.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include "absl/status/status.h"
#include "absl/strings/str_join.h"
#include "common/base/text.h"
#include "common/geometry/measure.h"
#include "common/geometry/rings/simple_rings.h"
#include "common/model/limits.h"

namespace slicefarm::config {
namespace {

constexpr double kSteps = 1e6;
constexpr double kLargest = 1e9;  // times kSteps, still an exact integer in a double
constexpr size_t kMaxCorners = 1000;
/// Names of PictureFormat, as in PrusaSlicer and OrcaSlicer.
constexpr const char* kPictureFormats[] = {"PNG", "QOI", "JPG", "BTT_TFT", "COLPIC"};

absl::Status Malformed(const std::string& why) { return absl::InvalidArgumentError(why); }

absl::StatusOr<Point> ParseCorner(std::string_view text) {
  const std::vector<std::string_view> parts = Split(text, "x");
  if (parts.size() != 2) return Malformed(fmt::format("'{}' is not XxY", text));
  const auto x = ParseNumber(parts[0], false);
  const auto y = ParseNumber(parts[1], false);
  if (!x.ok() || !y.ok()) return Malformed(fmt::format("'{}' is not XxY in mm", text));
  const double limit = ToMm(limits::kMaxCoord);
  if (std::abs(x->number) > limit || std::abs(y->number) > limit) {
    return Malformed(fmt::format("'{}' is more than {} mm away from the origin", text, limit));
  }
  return Point{FromMm(x->number), FromMm(y->number)};
}

std::optional<PictureFormat> FormatOf(std::string_view name) {
  const auto found = std::ranges::find(kPictureFormats, name);
  if (found == std::end(kPictureFormats)) return std::nullopt;
  return static_cast<PictureFormat>(found - std::begin(kPictureFormats));
}

absl::StatusOr<ThumbnailSize> ParseSize(std::string_view text) {
  const std::vector<std::string_view> parts = Split(text, "/");
  const auto format = parts.size() == 2 ? FormatOf(parts[1]) : PictureFormat::kPng;
  if (parts.size() > 2 || !format) {
    return Malformed(fmt::format("'{}': the format must be one of {}", text,
                                 absl::StrJoin(kPictureFormats, ", ")));
  }
  const std::vector<std::string_view> sides = Split(parts[0], "x");
  if (sides.size() != 2) return Malformed(fmt::format("'{}' is not WIDTHxHEIGHT", text));
  std::array<int32_t, 2> px = {0, 0};
  for (int i = 0; i < 2; ++i) {
    const auto side = ToNumber(sides[i]);
    if (!side.has_value() || *side != std::floor(*side) || *side < 1 ||
        *side > limits::kMaxThumbnailPx) {
      return Malformed(
          fmt::format("'{}' is not WIDTHxHEIGHT of 1 to {} pixels", text, limits::kMaxThumbnailPx));
    }
    px[i] = static_cast<int32_t>(*side);
  }
  return ThumbnailSize{px[0], px[1], *format};
}

}  // namespace

double Quantise(double number) {
  return std::round(number * kSteps) / kSteps + 0.0;  // + 0.0: no negative zero
}

absl::StatusOr<Value> ParseNumber(std::string_view text, bool may_be_percent) {
  text = Trim(text);
  Value value;
  if (may_be_percent && text.ends_with("%")) {
    value.percent = true;
    text = Trim(text.substr(0, text.size() - 1));
  }
  const auto number = ToNumber(text);
  if (!number.has_value() || std::abs(*number) > kLargest) {
    return Malformed(fmt::format("'{}' is not a number", text));
  }
  value.number = Quantise(*number);
  return value;
}

std::string PrintNumber(double number) {
  char digits[64];
  const auto end =
      std::to_chars(digits, digits + sizeof(digits), Quantise(number), std::chars_format::fixed);
  return std::string(digits, end.ptr);
}

std::string Unescape(std::string_view text) {
  std::string plain;
  plain.reserve(text.size());
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      plain += text[i];
      continue;
    }
    const char next = text[++i];
    plain += next == 'n' ? '\n' : next == 'r' ? '\r' : next;
  }
  return plain;
}

std::string Escape(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    if (c == '\n') {
      escaped += "\\n";
    } else if (c == '\r') {
      escaped += "\\r";
    } else {
      if (c == '\\') escaped += '\\';
      escaped += c;
    }
  }
  return escaped;
}

std::string TextOfList(std::string_view list, size_t index) {
  std::string_view rest = Trim(list);
  std::string first;
  for (size_t i = 0;; ++i) {
    const bool quoted = !rest.empty() && rest[0] == '"';
    size_t end = quoted ? 1 : std::min(rest.find(';'), rest.size());
    while (quoted && end < rest.size() && rest[end] != '"') end += rest[end] == '\\' ? 2 : 1;
    end = std::min(end, rest.size());
    std::string item =
        quoted ? Unescape(rest.substr(1, end - 1)) : std::string(Trim(rest.substr(0, end)));
    if (i == index) return item;
    if (i == 0) first = std::move(item);
    const size_t next = rest.find(';', end);
    if (next == std::string_view::npos) return first;
    rest = Trim(rest.substr(next + 1));
  }
}

std::string QuoteText(std::string_view text) {
  const bool plain = std::none_of(text.begin(), text.end(), [](char c) {
    return c == ' ' || c == ';' || c == '"' || c == '\\' || c == '\n' || c == '\r' || c == '\t';
  });
  if (plain) return std::string(text);
  std::string quoted = "\"";
  for (const char c : Escape(text)) {
    if (c == '"') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

namespace {

constexpr size_t kRectangle = 4;

absl::StatusOr<Polygon> ParseCorners(std::string_view text) {
  Polygon corners;
  for (const std::string_view corner : Split(text, ",")) {
    const auto point = ParseCorner(Trim(corner));
    if (!point.ok()) return point.status();
    corners.push_back(*point);
    if (corners.size() > kMaxCorners)
      return Malformed(fmt::format("more than {} corners", kMaxCorners));
  }
  return corners;
}

/// Returns true if four corners form an axis-parallel rectangle, in order.
bool IsRectangle(const Polygon& four) {
  const bool x_first = four[0].y == four[1].y && four[1].x == four[2].x && four[2].y == four[3].y &&
                       four[3].x == four[0].x;
  const bool y_first = four[0].x == four[1].x && four[1].y == four[2].y && four[2].x == four[3].x &&
                       four[3].y == four[0].y;
  return x_first || y_first;
}

/// Removes consecutive equal corners. Files that repeat the first corner at the end have them.
void DropRepeated(Polygon& bed) {
  bed.erase(std::unique(bed.begin(), bed.end()), bed.end());
  while (bed.size() > 1 && bed.front() == bed.back()) bed.pop_back();
}

}  // namespace

absl::StatusOr<Polygon> ParseBedShape(std::string_view text) {
  absl::StatusOr<Polygon> corners = ParseCorners(text);
  if (!corners.ok()) return corners.status();
  Polygon bed = *std::move(corners);
  DropRepeated(bed);
  if (bed.size() < 3) return Malformed("fewer than three corners");
  const Polygon* const outline = &bed;
  if (!AreSimple({&outline, 1})) return Malformed("the outline crosses or touches itself");
  if (SignedArea(bed) < 0) std::reverse(bed.begin(), bed.end());
  return bed;
}

std::string PrintBedShape(const Polygon& bed) {
  std::string text;
  for (const Point p : bed) text += (text.empty() ? "" : ",") + PrintPoint(p);
  return text;
}

absl::StatusOr<std::vector<Polygon>> ParseAreas(std::string_view text) {
  if (Trim(text).empty()) return std::vector<Polygon>();
  const absl::StatusOr<Polygon> corners = ParseCorners(text);
  if (!corners.ok()) return corners.status();
  std::vector<Polygon> areas;
  for (size_t i = 0; i + kRectangle <= corners->size(); i += kRectangle)
    areas.emplace_back(corners->begin() + static_cast<std::ptrdiff_t>(i),
                       corners->begin() + static_cast<std::ptrdiff_t>(i + kRectangle));
  if (corners->size() % kRectangle != 0 || !std::ranges::all_of(areas, IsRectangle))
    areas = {*corners};
  for (Polygon& area : areas)
    if (SignedArea(area) < 0) std::ranges::reverse(area);
  std::erase_if(areas,
                [](const Polygon& area) { return area.size() < 3 || SignedArea(area) == 0; });
  return areas;
}

std::string PrintAreas(const std::vector<Polygon>& areas) {
  Polygon corners;
  for (const Polygon& area : areas) corners.insert(corners.end(), area.begin(), area.end());
  return PrintBedShape(corners);
}

absl::StatusOr<Point> ParsePoint(std::string_view text) { return ParseCorner(Trim(text)); }

std::string PrintPoint(const Point& point) {
  return fmt::format("{}x{}", PrintNumber(ToMm(point.x)), PrintNumber(ToMm(point.y)));
}

absl::StatusOr<std::vector<ThumbnailSize>> ParseSizes(std::string_view text) {
  std::vector<ThumbnailSize> sizes;
  if (Trim(text).empty()) return sizes;
  for (const std::string_view item : Split(text, ",")) {
    const auto size = ParseSize(Trim(item));
    if (!size.ok()) return size.status();
    sizes.push_back(*size);
    if (std::ssize(sizes) > limits::kMaxThumbnails) {
      return Malformed(fmt::format("more than {} pictures", limits::kMaxThumbnails));
    }
  }
  return sizes;
}

std::string PrintSizes(const std::vector<ThumbnailSize>& sizes) {
  std::string text;
  for (const auto& [width, height, format, role] : sizes) {
    if (role != PictureRole::kProgram) continue;
    text += fmt::format("{}{}x{}", text.empty() ? "" : ",", width, height);
    if (format != PictureFormat::kPng)
      text += fmt::format("/{}", kPictureFormats[static_cast<size_t>(format)]);
  }
  return text;
}

}  // namespace slicefarm::config
