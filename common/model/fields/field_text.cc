#include "common/model/fields/field_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>
#include <vector>

#include "absl/strings/str_join.h"
#include "common/model/limits.h"

namespace slicefarm {
namespace {

using Json = nlohmann::json;

constexpr double kFarthestMm = 10'000;
constexpr double kUnityTolerance = 1e-3;

constexpr std::pair<DensityLaw, std::string_view> kLaws[] = {{DensityLaw::kLinear, "linear"},
                                                             {DensityLaw::kSimp, "simp"},
                                                             {DensityLaw::kRamp, "ramp"},
                                                             {DensityLaw::kHeaviside, "heaviside"}};
constexpr std::pair<Dither, std::string_view> kDithers[] = {
    {Dither::kNone, "none"},
    {Dither::kBlueNoise, "blue_noise"},
    {Dither::kFloydSteinberg, "floyd_steinberg"}};

absl::Status Wrong(const std::string& why) { return absl::InvalidArgumentError(why); }

/// Reader of the entries of one JSON object. After the first error it ignores all further entries.
class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) {
    if (!json.is_object()) Fail("a field must be a JSON object");
  }

  const absl::Status& status() const { return status_; }
  void Fail(const std::string& why) { status_.Update(Wrong(why)); }
  bool Has(const std::string& key) const { return status_.ok() && json_.contains(key); }

  /// Reports an error for any entry not in `known`, because such an entry would have no effect.
  void Only(const std::vector<std::string>& known) {
    if (!status_.ok()) return;
    for (const auto& [key, value] : json_.items()) {
      if (std::ranges::find(known, key) == known.end())
        Fail(fmt::format("unknown entry '{:.60}'; known entries: {}", key,
                         absl::StrJoin(known, ", ")));
    }
  }

  double Number(const std::string& key, double min, double max) {
    const Json* entry = Find(key);
    return entry == nullptr ? min : NumberOf(*entry, key, min, max);
  }
  double NumberOr(const std::string& key, double standard, double min, double max) {
    return Has(key) ? Number(key, min, max) : standard;
  }

  std::string Text(const std::string& key) {
    const Json* entry = Find(key);
    if (entry != nullptr && !entry->is_string()) Fail(fmt::format("{} must be a text", key));
    return status_.ok() ? entry->get<std::string>() : "";
  }

  template <class T>
  T OneOf(const std::string& key, std::span<const std::pair<T, std::string_view>> names) {
    if (!Has(key)) return names[0].first;
    const std::string text = Text(key);
    std::vector<std::string> all;
    for (const auto& [value, name] : names) {
      if (name == text) return value;
      all.emplace_back(name);
    }
    Fail(fmt::format("{} = '{:.60}': must be one of {}", key, text, absl::StrJoin(all, ", ")));
    return names[0].first;
  }

  /// Returns the numbers of an array. `size`: required number of elements; -1: any number from 1.
  std::vector<double> Numbers(const std::string& key, int64_t size, double min, double max) {
    std::vector<double> numbers;
    const Json* entry = Find(key);
    if (entry != nullptr && !entry->is_array()) Fail(fmt::format("{} must be a list", key));
    if (!status_.ok()) return numbers;
    const auto got = static_cast<int64_t>(entry->size());
    if (size >= 0 ? got != size : got < 1)
      Fail(fmt::format("{} has {} numbers: it must have {}", key, got,
                       size >= 0 ? std::to_string(size) : "at least one"));
    for (const Json& item : *entry) {
      if (!status_.ok()) break;
      numbers.push_back(NumberOf(item, key, min, max));
    }
    return numbers;
  }

  const Json* List(const std::string& key) {
    const Json* entry = Find(key);
    if (entry != nullptr && !entry->is_array()) Fail(fmt::format("{} must be a list", key));
    return status_.ok() ? entry : nullptr;
  }

 private:
  const Json* Find(const std::string& key) {
    if (!status_.ok()) return nullptr;
    const auto found = json_.find(key);
    if (found == json_.end()) {
      Fail(fmt::format("the entry '{}' is missing", key));
      return nullptr;
    }
    return &*found;
  }

  double NumberOf(const Json& json, const std::string& key, double min, double max) {
    const double number = json.is_number() ? json.get<double>() : NAN;
    if (!std::isfinite(number)) {
      Fail(fmt::format("{} contains a number that is not finite", key));
    } else if (number < min || number > max) {
      Fail(fmt::format("{} has {:.6g}: it must be {:.6g} to {:.6g}", key, number, min, max));
    } else {
      return number;
    }
    return min;
  }

  const Json& json_;
  absl::Status status_;
};

/// Reads the nodes of a grid, without its values.
FieldGrid ReadNodes(Reader& reader) {
  FieldGrid grid;
  const auto count = reader.Numbers("count", 3, 1, static_cast<double>(limits::kMaxFieldValues));
  const auto origin = reader.Numbers("origin", 3, -kFarthestMm, kFarthestMm);
  const auto spacing = reader.Numbers("spacing", 3, 1e-3, kFarthestMm);
  if (!reader.status().ok()) return grid;
  double nodes = 1;
  for (size_t i = 0; i < 3; ++i) {
    if (count[i] != std::floor(count[i])) reader.Fail("count contains a number that is not whole");
    nodes *= count[i];
    grid.count[i] = static_cast<int32_t>(count[i]);
    grid.origin_mm[i] = origin[i];
    grid.spacing_mm[i] = spacing[i];
  }
  if (nodes > static_cast<double>(limits::kMaxFieldValues))
    reader.Fail(fmt::format("the grid has {:.0f} nodes, at most {} are allowed", nodes,
                            limits::kMaxFieldValues));
  return grid;
}

int64_t NodeCount(const FieldGrid& grid) {
  return int64_t{grid.count[0]} * grid.count[1] * grid.count[2];
}

void ReadHeights(Reader& reader, DensityField& field) {
  const Json* table = reader.List("table");
  if (table == nullptr) return;
  if (table->empty()) reader.Fail("table has no rows");
  field.at_mm.clear();
  field.values.clear();
  for (const Json& row : *table) {
    const Json named = {{"row", row}};
    Reader cells(named);
    const auto numbers = cells.Numbers("row", 2, -kFarthestMm, kFarthestMm);
    if (!cells.status().ok()) return reader.Fail("table: " + std::string(cells.status().message()));
    if (numbers[1] < 0 || numbers[1] > 1)
      return reader.Fail(fmt::format("table has {:.6g}: it must be 0 to 1", numbers[1]));
    if (!field.at_mm.empty() && numbers[0] <= field.at_mm.back())
      return reader.Fail("the heights of table must increase");
    field.at_mm.push_back(numbers[0]);
    field.values.push_back(numbers[1]);
  }
}

void ReadLaw(Reader& reader, DensityField& field) {
  field.law = reader.OneOf<DensityLaw>("law", kLaws);
  field.steepness = reader.NumberOr("steepness", 3, 1e-3, 100);
  field.threshold = reader.NumberOr("threshold", 0.5, 0, 1);
  field.dither = reader.OneOf<Dither>("dither", kDithers);
  field.cell_mm = reader.NumberOr("cell", 2, 0.5, 100);
}

DensityField ReadDensityField(Reader& reader) {
  DensityField field;
  const std::string kind = reader.Text("kind");
  const auto only = [&](std::initializer_list<std::string_view> entries) {
    std::vector<std::string> known = {"kind", "law", "steepness", "threshold", "dither", "cell"};
    known.insert(known.end(), entries.begin(), entries.end());
    return known;
  };
  std::vector<std::string> known;
  if (kind == "constant") {
    known = only({"density"});
    field.values = {reader.Number("density", 0, 1)};
  } else if (kind == "height") {
    known = only({"table"});
    ReadHeights(reader, field);
  } else if (kind == "surface_distance") {
    known = only({"near", "far", "length"});
    field.kind = DensityField::Kind::kSurfaceDistance;
    field.at_mm = {0, reader.Number("length", 1e-3, kFarthestMm)};
    field.values = {reader.Number("near", 0, 1), reader.Number("far", 0, 1)};
  } else if (kind == "voxels") {
    known = only({"count", "origin", "spacing", "values"});
    field.kind = DensityField::Kind::kGrid;
    field.grid = ReadNodes(reader);
    field.grid.values = reader.Numbers("values", NodeCount(field.grid), 0, 1);
  } else {
    reader.Fail(fmt::format(
        "kind = '{:.60}': must be one of constant, height, surface_distance, voxels", kind));
  }
  reader.Only(known);
  ReadLaw(reader, field);
  return field;
}

StressField ReadStressField(Reader& reader) {
  StressField field;
  const std::string kind = reader.Text("kind");
  if (kind == "constant") {
    reader.Only({"kind", "stress", "smoothing"});
  } else if (kind == "voxels") {
    reader.Only({"kind", "count", "origin", "spacing", "stress", "smoothing"});
    field.xx = ReadNodes(reader);
    field.yy = field.xy = field.xx;
  } else {
    reader.Fail(fmt::format("kind = '{:.60}': must be one of constant, voxels", kind));
  }
  const auto numbers = reader.Numbers("stress", 3 * NodeCount(field.xx), -1e30, 1e30);
  const double passes = reader.NumberOr("smoothing", 1, 0, 100);
  if (passes != std::floor(passes)) reader.Fail("smoothing is not a whole number");
  if (!reader.status().ok()) return field;
  field.smoothing = static_cast<int32_t>(passes);
  for (FieldGrid* grid : {&field.xx, &field.yy, &field.xy}) grid->values.clear();
  for (size_t i = 0; i < numbers.size(); i += 3) {
    field.xx.values.push_back(numbers[i]);
    field.yy.values.push_back(numbers[i + 1]);
    field.xy.values.push_back(numbers[i + 2]);
  }
  return field;
}

const std::vector<double>& ValuesOf(const DensityField& part) {
  return part.kind == DensityField::Kind::kGrid ? part.grid.values : part.values;
}

/// Checks that the shares sum to 1 at each node. Then interpolation makes them sum to 1 in between.
absl::Status CheckUnity(const MaterialField& field) {
  const DensityField& first = field.parts[0];
  for (const DensityField& part : field.parts) {
    if (part.kind == DensityField::Kind::kSurfaceDistance)
      return Wrong("parts cannot depend on the distance to the surface");
    if (part.law != DensityLaw::kLinear || part.dither != Dither::kNone)
      return Wrong("parts must not have the entries law and dither");
    if (part.kind != first.kind || part.at_mm != first.at_mm || !SameNodes(part.grid, first.grid))
      return Wrong("all parts must be given at the same places");
  }
  for (size_t i = 0; i < ValuesOf(first).size(); ++i) {
    double sum = 0;
    for (const DensityField& part : field.parts) sum += ValuesOf(part)[i];
    if (std::abs(sum - 1) > kUnityTolerance)
      return Wrong(fmt::format("the values number {} of all parts sum to {:.6g}: the sum must be 1",
                               i, sum));
  }
  return absl::OkStatus();
}

absl::StatusOr<Json> JsonOf(std::string_view text) {
  Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) return Wrong("is not JSON");
  return json;
}

template <class T>
absl::StatusOr<T> Parse(std::string_view text, T (*read)(Reader&)) {
  const auto json = JsonOf(text);
  if (!json.ok()) return json.status();
  Reader reader(*json);
  T field = read(reader);
  if (!reader.status().ok()) return reader.status();
  return field;
}

std::string PrintNumbers(std::span<const double> numbers) {
  std::string text;
  for (size_t i = 0; i < numbers.size(); ++i)
    text += fmt::format("{}{:.6g}", i == 0 ? "" : ",", numbers[i]);
  return text;
}

std::string PrintNodes(const FieldGrid& grid) {
  return fmt::format("\"count\":[{}],\"origin\":[{}],\"spacing\":[{}]",
                     absl::StrJoin(grid.count, ","), PrintNumbers(grid.origin_mm),
                     PrintNumbers(grid.spacing_mm));
}

template <class T>
std::string_view NameOf(T value, std::span<const std::pair<T, std::string_view>> names) {
  return std::ranges::find(names, value, &std::pair<T, std::string_view>::first)->second;
}

std::string PrintLaw(const DensityField& field) {
  const DensityField standard;
  std::string text;
  if (field.law != standard.law)
    text += fmt::format(",\"law\":\"{}\"", NameOf<DensityLaw>(field.law, kLaws));
  if (field.steepness != standard.steepness)
    text += fmt::format(",\"steepness\":{:.6g}", field.steepness);
  if (field.threshold != standard.threshold)
    text += fmt::format(",\"threshold\":{:.6g}", field.threshold);
  if (field.dither != standard.dither)
    text += fmt::format(",\"dither\":\"{}\"", NameOf<Dither>(field.dither, kDithers));
  if (field.cell_mm != standard.cell_mm) text += fmt::format(",\"cell\":{:.6g}", field.cell_mm);
  return text + "}";
}

}  // namespace

absl::StatusOr<DensityField> ParseDensityField(std::string_view text) {
  return Parse(text, ReadDensityField);
}

absl::StatusOr<StressField> ParseStressField(std::string_view text) {
  auto field = Parse(text, ReadStressField);
  if (field.ok() && field->xx.values == field->yy.values &&
      std::ranges::all_of(field->xy.values, [](double value) { return value == 0; }))
    return Wrong(
        "the stress is the same in all directions everywhere, so that lines have no direction to "
        "follow");
  return field;
}

const absl::StatusOr<DensityField>& DensityFieldOf(const SharedText& text) {
  return text.Once([](const std::string& json) { return ParseDensityField(json); });
}

absl::StatusOr<MaterialField> ParseMaterialField(std::string_view text) {
  const auto json = JsonOf(text);
  if (!json.ok()) return json.status();
  Reader reader(*json);
  reader.Only({"parts", "step"});
  MaterialField field;
  field.step = reader.NumberOr("step", field.step, 1e-3, 1);
  const Json* parts = reader.List("parts");
  if (!reader.status().ok()) return reader.status();
  if (parts->size() < 2 || parts->size() > limits::kMaxMixedMaterials)
    return Wrong(fmt::format("there are {} parts, but there must be 2 to {}", parts->size(),
                             limits::kMaxMixedMaterials));
  for (const Json& part : *parts) {
    Reader one(part);
    field.parts.push_back(ReadDensityField(one));
    if (!one.status().ok())
      return Wrong(fmt::format("parts[{}]: {}", field.parts.size() - 1,
                               std::string(one.status().message())));
  }
  if (absl::Status ok = CheckUnity(field); !ok.ok()) return ok;
  return field;
}

std::string PrintDensityField(const DensityField& field) {
  std::string text;
  switch (field.kind) {
    case DensityField::Kind::kHeight: {
      std::vector<std::string> rows;
      for (size_t i = 0; i < field.at_mm.size(); ++i)
        rows.push_back(fmt::format("[{:.6g},{:.6g}]", field.at_mm[i], field.values[i]));
      text = fmt::format("{{\"kind\":\"height\",\"table\":[{}]", absl::StrJoin(rows, ","));
      break;
    }
    case DensityField::Kind::kSurfaceDistance:
      text = fmt::format(
          "{{\"kind\":\"surface_distance\",\"near\":{:.6g},\"far\":{:.6g},\"length\":{:.6g}",
          field.values[0], field.values[1], field.at_mm[1]);
      break;
    case DensityField::Kind::kGrid:
      text = fmt::format("{{\"kind\":\"voxels\",{},\"values\":[{}]", PrintNodes(field.grid),
                         PrintNumbers(field.grid.values));
      break;
  }
  return text + PrintLaw(field);
}

std::string PrintStressField(const StressField& field) {
  std::vector<double> numbers;
  for (size_t i = 0; i < field.xx.values.size(); ++i) {
    numbers.push_back(field.xx.values[i]);
    numbers.push_back(field.yy.values[i]);
    numbers.push_back(field.xy.values[i]);
  }
  std::string text = fmt::format("{{\"kind\":\"voxels\",{},\"stress\":[{}]", PrintNodes(field.xx),
                                 PrintNumbers(numbers));
  if (field.smoothing != StressField().smoothing)
    text += fmt::format(",\"smoothing\":{}", field.smoothing);
  return text + "}";
}

std::string PrintMaterialField(const MaterialField& field) {
  std::vector<std::string> parts;
  for (const DensityField& part : field.parts) parts.push_back(PrintDensityField(part));
  std::string text = fmt::format("{{\"parts\":[{}]", absl::StrJoin(parts, ","));
  if (field.step != MaterialField().step) text += fmt::format(",\"step\":{:.6g}", field.step);
  return text + "}";
}

}  // namespace slicefarm
