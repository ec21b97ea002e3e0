#include "services/exposure/algo/writers/cli_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "common/base/decimal_text.h"
#include "common/geometry/measure.h"
#include "services/exposure/algo/writers/style_text.h"

namespace slicefarm::exposure {
namespace {

enum Command : uint16_t { kLayerLong = 127, kPolylineLong = 130, kHatchesLong = 132 };
enum Winding { kClockwise = 0, kCounterClockwise = 1, kOpen = 2 };

bool IsBinary(const FileFacts& facts) { return facts.output.format == OutputFormat::kCliBinary; }

int32_t IdOf(int32_t object, int32_t settings, size_t kind, const FileFacts& facts) {
  const auto rows = static_cast<int32_t>(facts.regions.size());
  return (std::max(object, 0) * rows + settings) * kExposureKindCount + static_cast<int32_t>(kind) +
         1;
}

/// Returns a name that is valid in a label, without the characters that mark CLI's commands.
std::string LabelName(const std::string& name) {
  constexpr size_t kMost = 80;
  std::string text = name.substr(0, kMost);
  for (char& c : text)
    if (c == ',' || c == '$' || c == '/' || static_cast<unsigned char>(c) <= ' ') c = '_';
  return text;
}

std::string Labels(const FileFacts& facts) {
  std::string text;
  const size_t objects = std::max<size_t>(1, facts.object_names.size());
  for (size_t object = 0; object < objects; ++object)
    for (size_t settings = 0; settings < facts.regions.size(); ++settings)
      for (size_t kind = 0; kind < kExposureKindCount; ++kind)
        text += fmt::format(
            "$$LABEL/{},{}{}\n",
            IdOf(static_cast<int32_t>(object), static_cast<int32_t>(settings), kind, facts),
            StyleText(facts.regions[settings], kind),
            objects > 1 ? " part " + LabelName(facts.object_names[object]) : "");
  return text;
}

/// Writer of consecutive numbers in the file's units.
class Numbers {
 public:
  Numbers(const FileFacts& facts, std::string& text)
      : binary_(IsBinary(facts)), per_nm_(1 / (facts.output.unit_mm * kNmPerMm)), text_(text) {}

  void Integer(int32_t value) {
    if (binary_) return Bytes(static_cast<uint32_t>(value), 4);
    text_ += ',';
    AppendDecimal(text_, value, 0);
  }
  void Length(Coord nm) {
    if (binary_) return Bytes(std::bit_cast<uint32_t>(static_cast<float>(Units(nm))), 4);
    text_ += ',';
    AppendDecimal(text_, Thousandths(nm), 3);
  }
  /// Returns the length that a program reads from the file, in thousandths of a unit.
  double Read(Coord nm) const {
    return binary_ ? 1000 * static_cast<double>(static_cast<float>(Units(nm)))
                   : static_cast<double>(Thousandths(nm));
  }
  void Place(Point p) {
    Length(p.x);
    Length(p.y);
  }
  /// Begins a command. The first number after the command has no comma before it.
  void Start(Command command, std::string_view name) {
    if (binary_) return Bytes(command, 2);
    text_ += name;
    first_ = text_.size();
  }
  void End() {
    if (binary_) return;
    text_[first_] = '/';
    text_ += '\n';
  }

 private:
  double Units(Coord nm) const { return static_cast<double>(nm) * per_nm_; }
  int64_t Thousandths(Coord nm) const { return std::llround(Units(nm) * 1000); }

  void Bytes(uint32_t value, int count) {
    for (int i = 0; i < count; ++i) text_ += static_cast<char>(value >> (8 * i) & 0xff);
  }

  bool binary_;
  double per_nm_;
  std::string& text_;
  size_t first_ = 0;  ///< position of the first number, before which no comma is written
};

/// Returns the direction of a line with the file's rounded numbers. Rounding may reverse the
/// direction of a sliver.
Winding DirectionOf(std::span<const Point> line, Point shift, const Numbers& numbers) {
  if (line.size() < 4 || line.front() != line.back()) return kOpen;
  const auto x = [&](size_t i) { return numbers.Read(line[i].x + shift.x); };
  const auto y = [&](size_t i) { return numbers.Read(line[i].y + shift.y); };
  double area = 0;
  for (size_t i = 1; i + 1 < line.size(); ++i)
    area += (x(i) - x(0)) * (y(i + 1) - y(0)) - (x(i + 1) - x(0)) * (y(i) - y(0));
  return area == 0 ? kOpen : area < 0 ? kClockwise : kCounterClockwise;
}

void AppendGroup(const ExposureGroup& group, Point shift, const FileFacts& facts,
                 Numbers& numbers) {
  const int32_t id = IdOf(group.object, group.settings, static_cast<size_t>(group.kind), facts);
  if (group.IsHatch()) {
    numbers.Start(kHatchesLong, "$$HATCHES");
    numbers.Integer(id);
    numbers.Integer(static_cast<int32_t>(group.LineCount()));
    for (const Point p : group.points) numbers.Place(p + shift);
    return numbers.End();
  }
  group.ForEachLine([&](std::span<const Point> line) {
    numbers.Start(kPolylineLong, "$$POLYLINE");
    numbers.Integer(id);
    numbers.Integer(DirectionOf(line, shift, numbers));
    numbers.Integer(static_cast<int32_t>(line.size()));
    for (const Point p : line) numbers.Place(p + shift);
    numbers.End();
  });
}

}  // namespace

std::string CliHeader(const FileFacts& facts) {
  std::string text = fmt::format("$$HEADERSTART\n{}\n$$UNITS/{:.8f}\n$$VERSION/200\n",
                                 IsBinary(facts) ? "$$BINARY" : "$$ASCII", facts.output.unit_mm);
  text += Labels(facts);
  if (!facts.bounds.Empty()) {
    text += "$$DIMENSION/";
    const Coord sides[] = {facts.bounds.min.x, facts.bounds.min.y, facts.bottom_nm,
                           facts.bounds.max.x, facts.bounds.max.y, facts.top_nm};
    for (const Coord& side : sides) {
      AppendMm(text, side, 6);
      text += &side == &sides[5] ? '\n' : ',';
    }
  }
  text += fmt::format("$$LAYERS/{}\n$$HEADEREND", facts.layers);
  if (!IsBinary(facts)) text += "\n$$GEOMETRYSTART\n";
  return text;
}

std::string CliLayer(const ExposedLayer& layer, const FileFacts& facts) {
  std::string text;
  Numbers numbers(facts, text);
  numbers.Start(kLayerLong, "$$LAYER");
  numbers.Length(layer.frame.print_z_nm);
  numbers.End();
  for (const ExposureVisit& visit : layer.visits)
    for (const ExposureGroup& group : layer.groups)
      if (group.object == visit.object) AppendGroup(group, visit.shift, facts, numbers);
  return text;
}

std::string CliFooter(const FileFacts& facts) { return IsBinary(facts) ? "" : "$$GEOMETRYEND\n"; }

}  // namespace slicefarm::exposure
