#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm {
namespace text_format {

/// Reads the text from start to end.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  bool AtEnd() {
    SkipSpace();
    return at_ == text_.size();
  }
  bool Peek(char c) {
    SkipSpace();
    return at_ < text_.size() && text_[at_] == c;
  }
  bool Take(char c) {
    if (!Peek(c)) return false;
    ++at_;
    return true;
  }
  bool TakeCoord(Coord* coord) {
    SkipSpace();
    double mm = 0;
    const char* begin = text_.data() + at_;
    const auto result = std::from_chars(begin, text_.data() + text_.size(), mm);
    if (result.ec != std::errc() || !(std::abs(mm) < 1e12)) return false;
    at_ += static_cast<size_t>(result.ptr - begin);
    *coord = FromMm(mm);
    return true;
  }
  absl::Status Error(std::string_view expected) const {
    return absl::InvalidArgumentError(
        fmt::format("expected {} at offset {} of \"{}\"", expected, at_, text_));
  }

 private:
  void SkipSpace() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }

  std::string_view text_;
  size_t at_ = 0;
};

inline absl::StatusOr<Polyline> ReadLine(Reader& reader) {
  if (!reader.Take('(')) return reader.Error("'('");
  Polyline line;
  do {
    Point p;
    if (!reader.TakeCoord(&p.x) || !reader.TakeCoord(&p.y)) return reader.Error("two numbers");
    line.push_back(p);
  } while (reader.Take(','));
  if (!reader.Take(')')) return reader.Error("',' or ')'");
  return line;
}

inline void Turn(Polygon& ring, bool counter_clockwise) {
  if ((SignedArea(ring) > 0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
}

inline absl::StatusOr<PolygonWithHoles> ReadIsland(Reader& reader) {
  PolygonWithHoles island;
  do {
    auto ring = ReadLine(reader);
    if (!ring.ok()) return ring.status();
    if (ring->size() < 3) return reader.Error("three points or more before this");
    const bool outer = island.outer.empty();
    Turn(*ring, outer);
    if (outer) {
      island.outer = *std::move(ring);
    } else {
      island.holes.push_back(*std::move(ring));
    }
  } while (reader.Peek('('));
  return island;
}

template <typename T>
T ValueOrDie(absl::StatusOr<T> value) {
  if (value.ok()) return *std::move(value);
  std::cerr << value.status() << '\n';
  std::abort();
}

}  // namespace text_format

/// Geometry as text, for tests; lengths in millimetres.
///
///   line or ring    (0 0, 10 0, 10 10)
///   island          (outer ring) (hole) (hole)
///   islands         island ; island
///
/// The direction of rings is corrected: the first ring of an island becomes counter-clockwise, all
/// further rings clockwise. Errors: InvalidArgument with the offset of the unreadable text.
inline absl::StatusOr<Polyline> ParseLine(std::string_view text) {
  text_format::Reader reader(text);
  auto line = text_format::ReadLine(reader);
  if (line.ok() && !reader.AtEnd()) return reader.Error("the end");
  return line;
}

inline absl::StatusOr<MultiPolygon> ParseMultiPolygon(std::string_view text) {
  text_format::Reader reader(text);
  MultiPolygon polygons;
  if (reader.AtEnd()) return polygons;
  do {
    auto island = text_format::ReadIsland(reader);
    if (!island.ok()) return island.status();
    polygons.push_back(*std::move(island));
  } while (reader.Take(';'));
  if (!reader.AtEnd()) return reader.Error("'(' or ';'");
  return polygons;
}

inline std::string ToText(Point point);
inline std::string ToText(const Polyline& line);
inline std::string ToText(const PolygonWithHoles& polygon);
inline std::string ToText(const MultiPolygon& polygons);

template <typename T>
std::string JoinedTexts(const std::vector<T>& items, std::string_view separator) {
  std::string text;
  for (const T& item : items) {
    if (!text.empty()) text += separator;
    text += ToText(item);
  }
  return text;
}

inline std::string ToText(Point point) {
  return fmt::format("{} {}", ToMm(static_cast<double>(point.x)),
                     ToMm(static_cast<double>(point.y)));
}

inline std::string ToText(const Polyline& line) { return "(" + JoinedTexts(line, ", ") + ")"; }

inline std::string ToText(const PolygonWithHoles& polygon) {
  std::string text = ToText(polygon.outer);
  for (const Polygon& hole : polygon.holes) text += " " + ToText(hole);
  return text;
}

inline std::string ToText(const MultiPolygon& polygons) { return JoinedTexts(polygons, " ; "); }

/// Functions for literals; they terminate the program if the text cannot be read.
inline Polyline MakeLineOrDie(std::string_view text) {
  return text_format::ValueOrDie(ParseLine(text));
}
inline MultiPolygon MakePolygonsOrDie(std::string_view text) {
  return text_format::ValueOrDie(ParseMultiPolygon(text));
}

}  // namespace slicefarm
