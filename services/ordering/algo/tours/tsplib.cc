#include "services/ordering/algo/tours/tsplib.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "common/base/disjoint_sets.h"
#include "common/base/error.h"
#include "common/base/portable_math.h"
#include "common/base/text.h"

namespace slicefarm::ordering {
namespace {

struct Word {
  std::string_view text;
  size_t line;
};

/// Joins words and numbers to one string.
template <typename... Parts>
std::string Text(const Parts&... parts) {
  return (fmt::format("{}", parts) + ...);
}

absl::Status Malformed(size_t line, std::string_view what) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   Text("line ", line, ": ", what), {{"line", Text(line)}});
}

/// Content of a file before it is interpreted: the values of its keys, the words of its sections.
struct Specification {
  std::map<std::string_view, Word> values;
  std::map<std::string_view, std::vector<Word>> sections;
  size_t lines = 0;

  std::string_view Value(std::string_view key) const {
    const auto found = values.find(key);
    return found == values.end() ? std::string_view() : found->second.text;
  }
  size_t LineOf(std::string_view key) const {
    const auto found = values.find(key);
    return found == values.end() ? lines : found->second.line;
  }
};

constexpr std::array<std::string_view, 8> kKeys = {"NAME",
                                                   "TYPE",
                                                   "COMMENT",
                                                   "DIMENSION",
                                                   "EDGE_WEIGHT_TYPE",
                                                   "NODE_COORD_TYPE",
                                                   "EDGE_WEIGHT_FORMAT",
                                                   "DISPLAY_DATA_TYPE"};
constexpr std::array<std::string_view, 4> kSections = {
    "NODE_COORD_SECTION", "EDGE_WEIGHT_SECTION", "FIXED_EDGES_SECTION", "DISPLAY_DATA_SECTION"};

bool IsNumbers(std::string_view line) {
  return line.find_first_of("0123456789") == line.find_first_not_of("+-. \t");
}

void AddWords(std::string_view text, size_t line, std::vector<Word>& words) {
  for (const std::string_view word : Split(text, " \t\r")) {
    if (!word.empty()) words.push_back({word, line});
  }
}

absl::StatusOr<Specification> Parse(std::string_view text) {
  Specification specification;
  std::vector<Word>* section = nullptr;
  for (const std::string_view raw : Split(text, "\n")) {
    const size_t number = ++specification.lines;
    const std::string_view line = Trim(raw);
    if (line.empty()) continue;
    if (section != nullptr && IsNumbers(line)) {
      AddWords(line, number, *section);
      continue;
    }
    if (line == "EOF") break;
    const size_t colon = line.find(':');
    const std::string_view key = Trim(line.substr(0, colon));
    if (std::ranges::find(kSections, key) != kSections.end()) {
      const auto [at, added] = specification.sections.try_emplace(key);
      if (!added) return Malformed(number, Text(key, " comes twice"));
      section = &at->second;
      continue;
    }
    if (colon == line.npos || std::ranges::find(kKeys, key) == kKeys.end())
      return Malformed(number, Text("'", key.substr(0, 40), "' is not a known key"));
    const Word value{Trim(line.substr(colon + 1)), number};
    if (!specification.values.emplace(key, value).second && key != "COMMENT")
      return Malformed(number, Text(key, " comes twice"));
    section = nullptr;
  }
  return specification;
}

absl::StatusOr<double> NumberOf(const Word& word) {
  const std::optional<double> number = ToNumber(word.text);
  if (!number) return Malformed(word.line, Text("'", word.text.substr(0, 40), "' is not a number"));
  return *number;
}

/// Returns a node's number, counted from 0.
absl::StatusOr<int32_t> NodeOf(const Word& word, int32_t size) {
  const absl::StatusOr<double> number = NumberOf(word);
  if (!number.ok()) return number.status();
  if (*number < 1 || *number > size || *number != std::floor(*number)) {
    return Malformed(word.line,
                     Text("'", word.text.substr(0, 40), "' is not a node of 1 .. ", size));
  }
  return static_cast<int32_t>(*number) - 1;
}

absl::StatusOr<int32_t> SizeOf(const Specification& specification, int32_t limit) {
  const size_t line = specification.LineOf("DIMENSION");
  const std::optional<double> size = ToNumber(specification.Value("DIMENSION"));
  if (!size || *size < 1 || *size != std::floor(*size))
    return Malformed(line, "DIMENSION must be a whole number, at least 1");
  if (*size > limit) {
    return LimitError(Reason::kRequestTooLarge, "DIMENSION", limit,
                      static_cast<int64_t>(std::min(*size, 1e18)));
  }
  return static_cast<int32_t>(*size);
}

absl::StatusOr<std::vector<Vector2>> PlacesOf(const Specification& specification, int32_t size) {
  const auto section = specification.sections.find("NODE_COORD_SECTION");
  if (section == specification.sections.end())
    return Malformed(specification.lines, "there is no NODE_COORD_SECTION");
  const std::vector<Word>& words = section->second;
  if (words.size() != 3 * static_cast<size_t>(size)) {
    return Malformed(words.empty() ? specification.lines : words.back().line,
                     Text("NODE_COORD_SECTION has ", words.size(), " numbers, for ", size,
                          " nodes it needs ", 3 * int64_t{size}));
  }
  std::vector<std::optional<Vector2>> points(static_cast<size_t>(size));
  for (size_t i = 0; i < words.size(); i += 3) {
    const absl::StatusOr<int32_t> node = NodeOf(words[i], size);
    const absl::StatusOr<double> x = NumberOf(words[i + 1]);
    const absl::StatusOr<double> y = NumberOf(words[i + 2]);
    for (const absl::Status& status : {node.status(), x.status(), y.status()}) {
      if (!status.ok()) return status;
    }
    if (std::abs(*x) > kGreatestWeight || std::abs(*y) > kGreatestWeight)
      return Malformed(words[i].line, "a coordinate beyond 1e9");
    std::optional<Vector2>& place = points[static_cast<size_t>(*node)];
    if (place) return Malformed(words[i].line, Text("node ", *node + 1, " comes twice"));
    place = Vector2{*x, *y};
  }
  std::vector<Vector2> all;
  all.reserve(points.size());
  for (const std::optional<Vector2>& place : points) all.push_back(*place);
  return all;
}

/// Converts degrees in TSPLIB's form DDD.MM to radians.
double Radians(double degrees_minutes) {
  const double degrees = std::trunc(degrees_minutes);
  return 3.141592 * (degrees + 5.0 * (degrees_minutes - degrees) / 3.0) / 180.0;
}

/// Returns TSPLIB's distances on the globe, in km.
Costs OnTheGlobe(const std::vector<Vector2>& points) {
  const size_t size = points.size();
  std::vector<int32_t> table(size * size, 0);
  for (size_t a = 0; a < size; ++a) {
    for (size_t b = 0; b < a; ++b) {
      const double q1 = Cos(Radians(points[a].y()) - Radians(points[b].y()));
      const double q2 = Cos(Radians(points[a].x()) - Radians(points[b].x()));
      const double q3 = Cos(Radians(points[a].x()) + Radians(points[b].x()));
      const double cosine = 0.5 * ((1.0 + q1) * q2 - (1.0 - q1) * q3);
      const auto km = static_cast<int32_t>(6378.388 * Acos(std::clamp(cosine, -1.0, 1.0)) + 1.0);
      table[a * size + b] = table[b * size + a] = km;
    }
  }
  return Costs::OfTable(static_cast<int32_t>(size), std::move(table));
}

absl::StatusOr<Costs> GeographicCosts(const Specification& specification) {
  const absl::StatusOr<int32_t> size = SizeOf(specification, kMostTableNodes);
  if (!size.ok()) return size.status();
  const auto points = PlacesOf(specification, *size);
  if (!points.ok()) return points.status();
  for (const Vector2& place : *points) {
    if (std::abs(place.x()) > 360 || std::abs(place.y()) > 360)
      return Malformed(specification.lines, "a coordinate beyond 360 degrees");
  }
  return OnTheGlobe(*points);
}

/// Column ranges of each row of a weight table, in one of TSPLIB's formats.
class TableWalk {
 public:
  /// Returns the walk for a format, or nothing if the format is unknown.
  static std::optional<TableWalk> Of(std::string_view format, size_t size) {
    if (format == "FULL_MATRIX") return TableWalk(size, true, true, 0);
    if (format == "UPPER_ROW") return TableWalk(size, true, false, 1);
    if (format == "UPPER_DIAG_ROW") return TableWalk(size, true, false, 0);
    if (format == "LOWER_ROW") return TableWalk(size, false, true, 1);
    if (format == "LOWER_DIAG_ROW") return TableWalk(size, false, true, 0);
    return std::nullopt;
  }
  /// Returns the first column of a row. The row's columns are First(row) .. Last(row) - 1.
  size_t First(size_t row) const { return upper_ && !lower_ ? row + skipped_ : 0; }
  size_t Last(size_t row) const { return upper_ ? size_ : row + 1 - skipped_; }
  size_t Count() const {
    size_t count = 0;
    for (size_t row = 0; row < size_; ++row) count += Last(row) - std::min(First(row), Last(row));
    return count;
  }

 private:
  TableWalk(size_t size, bool upper, bool lower, size_t skipped)
      : size_(size), upper_(upper), lower_(lower), skipped_(skipped) {}

  size_t size_;
  bool upper_;
  bool lower_;
  size_t skipped_;  ///< 1 if the table has no diagonal, else 0
};

absl::StatusOr<Costs> ExplicitCosts(const Specification& specification) {
  const absl::StatusOr<int32_t> dimension = SizeOf(specification, kMostTableNodes);
  if (!dimension.ok()) return dimension.status();
  const auto size = static_cast<size_t>(*dimension);
  const std::string_view format = specification.Value("EDGE_WEIGHT_FORMAT");
  const std::optional<TableWalk> walk = TableWalk::Of(format, size);
  if (!walk) {
    return Malformed(specification.LineOf("EDGE_WEIGHT_FORMAT"),
                     Text("EDGE_WEIGHT_FORMAT '", format.substr(0, 40),
                          "' must be FULL_MATRIX, UPPER_ROW, LOWER_ROW, UPPER_DIAG_ROW or "
                          "LOWER_DIAG_ROW"));
  }
  const auto section = specification.sections.find("EDGE_WEIGHT_SECTION");
  if (section == specification.sections.end())
    return Malformed(specification.lines, "there is no EDGE_WEIGHT_SECTION");
  const std::vector<Word>& words = section->second;
  if (words.size() != walk->Count()) {
    return Malformed(words.empty() ? specification.lines : words.back().line,
                     Text("EDGE_WEIGHT_SECTION has ", words.size(), " numbers, ", format, " of ",
                          size, " nodes takes ", walk->Count()));
  }
  constexpr int32_t kUnknown = -1;
  std::vector<int32_t> table(size * size, kUnknown);
  auto word = words.begin();
  for (size_t a = 0; a < size; ++a) {
    for (size_t b = walk->First(a); b < walk->Last(a); ++b, ++word) {
      const absl::StatusOr<double> weight = NumberOf(*word);
      if (!weight.ok()) return weight.status();
      if (*weight < 0 || *weight > kGreatestWeight || *weight != std::floor(*weight))
        return Malformed(word->line, "a weight must be a whole number from 0 to 1e9");
      const auto length = static_cast<int32_t>(*weight);
      if (a != b && table[b * size + a] != kUnknown && table[b * size + a] != length) {
        return Malformed(word->line, Text("the weights between ", a + 1, " and ", b + 1,
                                          " differ: only symmetric weights are supported"));
      }
      table[a * size + b] = table[b * size + a] = length;
    }
  }
  return Costs::OfTable(*dimension, std::move(table));
}

absl::StatusOr<Costs> PlaneCosts(const Specification& specification, Metric metric) {
  const absl::StatusOr<int32_t> size = SizeOf(specification, kMaxPoints);
  if (!size.ok()) return size.status();
  auto points = PlacesOf(specification, *size);
  if (!points.ok()) return points.status();
  return Costs::OfPoints(*std::move(points), metric);
}

absl::StatusOr<Costs> CostsOf(const Specification& specification) {
  const std::string_view type = specification.Value("EDGE_WEIGHT_TYPE");
  if (type == "EUC_2D") return PlaneCosts(specification, Metric::kNearest);
  if (type == "CEIL_2D") return PlaneCosts(specification, Metric::kUp);
  if (type == "ATT") return PlaneCosts(specification, Metric::kAtt);
  if (type == "GEO") return GeographicCosts(specification);
  if (type == "EXPLICIT") return ExplicitCosts(specification);
  return Malformed(specification.LineOf("EDGE_WEIGHT_TYPE"),
                   Text("EDGE_WEIGHT_TYPE '", type.substr(0, 40),
                        "' must be EUC_2D, CEIL_2D, ATT, GEO or EXPLICIT"));
}

/// Checks fixed edges and rejects edges that no tour can keep: a third edge at a node, or a ring of
/// fewer than all nodes.
class FixedEdgesReader {
 public:
  explicit FixedEdgesReader(int32_t size)
      : size_(size), degree_(static_cast<size_t>(size), 0), pieces_(size) {}

  absl::Status Add(NodePair edge, size_t line) {
    if (edge.a == edge.b) return Malformed(line, "a fixed edge from a node to itself");
    if (++degree_[static_cast<size_t>(edge.a)] > 2 || ++degree_[static_cast<size_t>(edge.b)] > 2)
      return Malformed(line, "a third fixed edge at a node");
    edges_.push_back(edge);
    if (!pieces_.Join(edge.a, edge.b) && (edges_.size() != static_cast<size_t>(size_) || size_ < 3))
      return Malformed(line, "fixed edges that make a ring of fewer than all nodes");
    return absl::OkStatus();
  }

  std::vector<NodePair> Take() { return std::move(edges_); }

 private:
  int32_t size_;
  std::vector<int> degree_;
  DisjointSets pieces_;
  std::vector<NodePair> edges_;
};

absl::StatusOr<std::vector<NodePair>> FixedOf(const Specification& specification, int32_t size) {
  const auto section = specification.sections.find("FIXED_EDGES_SECTION");
  if (section == specification.sections.end()) return std::vector<NodePair>{};
  const std::vector<Word>& words = section->second;
  if (words.empty() || words.back().text != "-1")
    return Malformed(words.empty() ? specification.lines : words.back().line,
                     "FIXED_EDGES_SECTION must end with -1");
  if (words.size() % 2 == 0) return Malformed(words.back().line, "half a fixed edge");
  FixedEdgesReader reader(size);
  for (size_t i = 0; i + 1 < words.size(); i += 2) {
    const absl::StatusOr<int32_t> a = NodeOf(words[i], size);
    if (!a.ok()) return a.status();
    const absl::StatusOr<int32_t> b = NodeOf(words[i + 1], size);
    if (!b.ok()) return b.status();
    if (absl::Status ok = reader.Add({*a, *b}, words[i].line); !ok.ok()) return ok;
  }
  return reader.Take();
}

}  // namespace

absl::StatusOr<TspInstance> ReadTsplib(std::string_view text) {
  const absl::StatusOr<Specification> specification = Parse(text);
  if (!specification.ok()) return specification.status();
  const std::string_view type = specification->Value("TYPE");
  if (type.substr(0, type.find_first_of(" \t")) != "TSP") {
    return Malformed(specification->LineOf("TYPE"),
                     Text("TYPE '", type.substr(0, 40), "' must be TSP"));
  }
  const std::string_view coordinates = specification->Value("NODE_COORD_TYPE");
  if (!coordinates.empty() && coordinates != "TWOD_COORDS" && coordinates != "NO_COORDS")
    return Malformed(specification->LineOf("NODE_COORD_TYPE"), "only TWOD_COORDS is supported");
  absl::StatusOr<Costs> costs = CostsOf(*specification);
  if (!costs.ok()) return costs.status();
  auto fixed = FixedOf(*specification, costs->size());
  if (!fixed.ok()) return fixed.status();
  return TspInstance{std::string(specification->Value("NAME")), *std::move(costs),
                     *std::move(fixed)};
}

std::string PrintTour(const std::string& name, const Tour& tour) {
  std::string text =
      Text("NAME : ", name, "\nTYPE : TOUR\nDIMENSION : ", tour.size(), "\nTOUR_SECTION\n");
  for (const int32_t node : tour) text += std::to_string(node + 1) + "\n";
  return text + "-1\nEOF\n";
}

}  // namespace slicefarm::ordering
