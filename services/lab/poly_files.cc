#include "services/lab/poly_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/measure.h"

namespace slicefarm::lab {
namespace {

constexpr Coord kMaxCoord = Coord{1} << 51;  ///< limit of coordinates in a decomposition
constexpr int kMaxDecimals = 18;

absl::Status NotPolygons(const std::string& what) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "not a polygon file: " + what);
}

using LineWords = std::vector<std::string_view>;

LineWords Split(std::string_view text) {
  LineWords words;
  for (size_t i = 0; i < text.size();) {
    if (text[i] == '#') {
      while (i < text.size() && text[i] != '\n') ++i;
    } else if (text[i] <= ' ') {
      ++i;
    } else {
      const size_t start = i;
      while (i < text.size() && text[i] > ' ' && text[i] != '#') ++i;
      words.push_back(text.substr(start, i - start));
    }
  }
  return words;
}

std::optional<int64_t> ToCount(std::string_view word) {
  int64_t count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc() || end != word.data() + word.size() || count < 0) return std::nullopt;
  return count;
}

/// A decimal number as digits and a power of ten.
struct Decimal {
  bool negative = false;
  std::string digits;  ///< without leading or trailing zeros; empty: 0
  int64_t exponent = 0;

  /// Returns the number of decimals that the number needs.
  int64_t Decimals() const { return digits.empty() ? 0 : std::max<int64_t>(0, -exponent); }
  /// Returns the power of ten of the first digit.
  int64_t Magnitude() const { return std::ssize(digits) - 1 + exponent; }
};

std::optional<Decimal> ToDecimal(std::string_view word) {
  Decimal number;
  size_t i = 0;
  if (!word.empty() && (word[0] == '-' || word[0] == '+')) number.negative = word[i++] == '-';
  bool point = false, any = false;
  for (; i < word.size() && word[i] != 'e' && word[i] != 'E'; ++i) {
    if (word[i] == '.' && !point) {
      point = true;
    } else if (word[i] >= '0' && word[i] <= '9') {
      any = true;
      if (word[i] != '0' || !number.digits.empty()) number.digits += word[i];
      number.exponent -= point ? 1 : 0;
    } else {
      return std::nullopt;
    }
  }
  if (!any) return std::nullopt;
  if (i < word.size()) {
    std::string_view rest = word.substr(i + 1);
    if (rest.starts_with('+')) rest.remove_prefix(1);
    int exponent = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), exponent);
    if (error != std::errc() || end != rest.data() + rest.size() || std::abs(exponent) > 400)
      return std::nullopt;
    number.exponent += exponent;
  }
  while (number.digits.ends_with('0')) {
    number.digits.pop_back();
    ++number.exponent;
  }
  return number;
}

/// Returns the number times 10^decimals, rounded half away from zero. REQUIRES: it fits.
Coord Scaled(const Decimal& number, int decimals) {
  Coord value = 0;
  int64_t power = number.exponent + decimals;
  const int64_t kept = std::ssize(number.digits) + std::min<int64_t>(0, power);
  for (int64_t i = 0; i < kept; ++i)
    value = 10 * value + (number.digits[static_cast<size_t>(i)] - '0');
  if (power < 0 && kept >= 0 && kept < std::ssize(number.digits) &&
      number.digits[static_cast<size_t>(kept)] >= '5')
    ++value;
  for (; power > 0 && value != 0; --power) value *= 10;
  return number.negative ? -value : value;
}

/// A ring as read from the file.
struct ReadRing {
  std::vector<Decimal> numbers;  ///< x, y, x, y, ...
  /// true for a hole, false for an outer ring; nullopt: the nesting of rings decides
  std::optional<bool> hole;
};

/// Reads words one after another.
class WordReader {
 public:
  explicit WordReader(LineWords words) : words_(std::move(words)) {}

  bool AtEnd() const { return next_ >= words_.size(); }
  std::string_view Next() { return AtEnd() ? std::string_view() : words_[next_++]; }

  bool ReadNumbers(int64_t count, std::vector<Decimal>& numbers) {
    if (count > std::ssize(words_)) return false;
    for (int64_t i = 0; i < count; ++i) {
      const std::optional<Decimal> number = ToDecimal(Next());
      if (!number) return false;
      numbers.push_back(*number);
    }
    return true;
  }

 private:
  LineWords words_;
  size_t next_ = 0;
};

bool HasChains(const LineWords& words) {
  return words.size() > 2 && (words[2] == "in" || words[2] == "out");
}

absl::StatusOr<std::vector<ReadRing>> ReadChains(const LineWords& words) {
  WordReader reader(words);
  std::vector<ReadRing> rings;
  const std::optional<int64_t> chains = ToCount(reader.Next());
  if (!chains) return NotPolygons("the number of chains is missing");
  for (int64_t chain = 0; chain < *chains; ++chain) {
    const std::optional<int64_t> count = ToCount(reader.Next());
    const std::string_view kind = reader.Next();
    if (!count || *count < 3 || (kind != "in" && kind != "out"))
      return NotPolygons(
          fmt::format("chain {} has no number of points with `in` or `out`", chain + 1));
    std::vector<Decimal> listed;
    if (!reader.ReadNumbers(2 * *count, listed))
      return NotPolygons(fmt::format("chain {} has too few points", chain + 1));
    ReadRing ring{.numbers = {}, .hole = kind == "in"};
    for (int64_t i = 0; i < *count; ++i) {
      const std::optional<int64_t> at = ToCount(reader.Next());
      if (!at || *at < 1 || *at > *count)
        return NotPolygons(fmt::format("chain {}: the order of its points is wrong", chain + 1));
      ring.numbers.push_back(listed[static_cast<size_t>(2 * *at - 2)]);
      ring.numbers.push_back(listed[static_cast<size_t>(2 * *at - 1)]);
    }
    rings.push_back(std::move(ring));
  }
  if (!reader.AtEnd()) return NotPolygons("there is text after the last chain");
  return rings;
}

/// Reads the format `outlines`: two unused numbers, then rings. Returns nullopt if the text has
/// another format.
std::optional<std::vector<ReadRing>> ReadOutlineRings(const LineWords& words) {
  WordReader reader(words);
  reader.Next();
  reader.Next();
  std::vector<ReadRing> rings;
  while (!reader.AtEnd()) {
    const std::optional<int64_t> count = ToCount(reader.Next());
    ReadRing ring;
    if (!count || *count < 3 || !reader.ReadNumbers(2 * *count, ring.numbers)) return std::nullopt;
    rings.push_back(std::move(ring));
  }
  if (rings.empty()) return std::nullopt;
  return rings;
}

absl::StatusOr<std::vector<ReadRing>> ReadRings(const LineWords& words) {
  if (HasChains(words)) return ReadChains(words);
  if (auto rings = ReadOutlineRings(words)) return *rings;
  WordReader reader(words);
  ReadRing ring{.numbers = {}, .hole = false};
  if (words.size() < 6 || words.size() % 2 != 0 ||
      !reader.ReadNumbers(std::ssize(words), ring.numbers))
    return NotPolygons("neither chains, nor outlines, nor `x y` a line");
  return std::vector<ReadRing>{std::move(ring)};
}

/// Splits a ring that passes points twice into loops that pass each point once. Loops with zero
/// area are removed.
std::vector<Polygon> Loops(const Polygon& ring) {
  std::vector<Polygon> loops;
  Polygon path;
  std::map<Point, size_t> places;  // index in `path` of each of its points
  const auto add = [&](Polygon loop) {
    if (loop.size() > 2 && SignedArea(loop) != 0) loops.push_back(std::move(loop));
  };
  for (const Point p : ring) {
    if (const auto seen = places.find(p); seen != places.end()) {
      const auto start = path.begin() + static_cast<ptrdiff_t>(seen->second);
      for (auto q = start; q != path.end(); ++q)
        if (*q != p) places.erase(*q);
      add(Polygon(start, path.end()));
      path.erase(start + 1, path.end());
    } else {
      places.emplace(p, path.size());
      path.push_back(p);
    }
  }
  add(std::move(path));
  return loops;
}

/// Returns the number of other rings that contain the ring.
int Depth(size_t ring, const std::vector<Polygon>& rings) {
  int depth = 0;
  for (size_t other = 0; other < rings.size(); ++other) {
    if (other == ring) continue;
    for (const Point p : rings[ring]) {
      const Side side = Locate(p, rings[other]);
      if (side == Side::kBoundary) continue;
      depth += side == Side::kInside ? 1 : 0;
      break;
    }
  }
  return depth;
}

bool Inside(const Polygon& ring, const Polygon& outer) {
  for (const Point p : ring)
    if (const Side side = Locate(p, outer); side != Side::kBoundary) return side == Side::kInside;
  return false;
}

void Turn(Polygon& ring, bool hole) {
  if ((SignedArea(ring) < 0) != hole) std::reverse(ring.begin(), ring.end());
}

absl::StatusOr<MultiPolygon> Nested(std::vector<Polygon> rings, const std::vector<bool>& holes) {
  MultiPolygon islands;
  for (size_t i = 0; i < rings.size(); ++i) {
    Turn(rings[i], holes[i]);
    if (!holes[i]) islands.push_back({.outer = rings[i], .holes = {}});
  }
  for (size_t i = 0; i < rings.size(); ++i) {
    if (!holes[i]) continue;
    PolygonWithHoles* owner = nullptr;  // the smallest island around the hole
    for (PolygonWithHoles& island : islands)
      if (Inside(rings[i], island.outer) &&
          (owner == nullptr || SignedArea(island.outer) < SignedArea(owner->outer)))
        owner = &island;
    if (owner == nullptr) return NotPolygons("a hole lies outside of all outer rings");
    owner->holes.push_back(std::move(rings[i]));
  }
  return islands;
}

}  // namespace

absl::StatusOr<PolyFile> ParsePoly(std::string_view text) {
  const absl::StatusOr<std::vector<ReadRing>> read = ReadRings(Split(text));
  if (!read.ok()) return read.status();
  int64_t decimals = 0, magnitude = 0;
  for (const ReadRing& ring : *read)
    for (const Decimal& number : ring.numbers) {
      decimals = std::max(decimals, number.Decimals());
      magnitude = std::max(magnitude, number.Magnitude());
    }
  // 10^15 < kMaxCoord.
  if (magnitude > 14) return NotPolygons("a number is too large");
  PolyFile file;
  file.decimals = static_cast<int>(std::min<int64_t>({decimals, 14 - magnitude, kMaxDecimals}));
  std::vector<Polygon> rings;
  std::vector<std::optional<bool>> given_holes;  // true: a hole; nullopt: the file does not say it
  for (const ReadRing& ring : *read) {
    Polygon points;
    for (size_t i = 0; i + 1 < ring.numbers.size(); i += 2)
      points.push_back(
          {Scaled(ring.numbers[i], file.decimals), Scaled(ring.numbers[i + 1], file.decimals)});
    std::vector<Polygon> loops;
    if (ring.hole)
      loops.push_back(std::move(points));
    else
      loops = Loops(points);
    std::move(loops.begin(), loops.end(), std::back_inserter(rings));
    given_holes.resize(rings.size(), ring.hole);
  }
  std::vector<bool> holes;
  for (size_t i = 0; i < rings.size(); ++i)
    holes.push_back(given_holes[i].value_or(Depth(i, rings) % 2 == 1));
  auto islands = Nested(std::move(rings), holes);
  if (!islands.ok()) return islands.status();
  file.islands = *std::move(islands);
  return file;
}

std::string DecimalText(Coord value, int decimals) {
  const std::string digits = fmt::format("{:0{}}", std::abs(value), decimals + 1);
  const size_t whole = digits.size() - static_cast<size_t>(decimals);
  std::string fraction = digits.substr(whole);
  while (fraction.ends_with('0')) fraction.pop_back();
  return fmt::format("{}{}{}{}", value < 0 ? "-" : "", digits.substr(0, whole),
                     fraction.empty() ? "" : ".", fraction);
}

}  // namespace slicefarm::lab
