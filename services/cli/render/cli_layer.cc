#include "services/cli/render/cli_layer.h"

#include <fmt/core.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/numbers.h"
#include "common/base/error.h"
#include "common/base/text.h"
#include "common/geometry/polygon.h"
#include "services/cli/render/line_style.h"

namespace slicefarm::cli {
namespace {

constexpr std::string_view kHeaderStart = "$$HEADERSTART";
constexpr std::string_view kHeaderEnd = "$$HEADEREND";

absl::Status NotCli(const std::string& what) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "not a valid CLI file: " + what);
}

/// Replaces each `// comment //` by a blank. Text without the end mark is no comment.
std::string WithoutComments(std::string_view text) {
  std::string rest;
  for (;;) {
    const size_t begin = text.find("//");
    const size_t end = begin == std::string_view::npos ? begin : text.find("//", begin + 2);
    rest += text.substr(0, end == std::string_view::npos ? end : begin);
    if (end == std::string_view::npos) return rest;
    rest += ' ';
    text.remove_prefix(end + 2);
  }
}

/// Returns the feature for the colours: the kind in slicefarm's labels, or else contour or hatch.
std::string FeatureOf(const LineStyle& style, const char* command) {
  for (const char* kind : {"contour", "hatch", "upskin", "downskin", "thin wall"})
    if (style.kind == kind) return kind;
  return command;
}

/// Collects the commands of a file, and keeps the requested layer.
class LayerKeeper {
 public:
  LayerKeeper(int index, double unit_mm, double width_mm, std::map<int, LineStyle> styles)
      : unit_mm_(unit_mm), width_mm_(width_mm), styles_(std::move(styles)) {
    layer_.index = index;
  }

  void Layer(double z) {
    const double z_mm = z * unit_mm_;
    if (layer_.layer_count == layer_.index) {
      layer_.z_mm = z_mm;
      layer_.height_mm = z_mm - last_z_mm_;
    }
    last_z_mm_ = z_mm;
    ++layer_.layer_count;
  }

  /// `xy`: coordinates of all points, in units.
  void Polyline(int id, const std::vector<double>& xy) { Add("contour", id, xy, 0, xy.size()); }
  void Hatches(int id, const std::vector<double>& xy) {
    for (size_t i = 0; i + 4 <= xy.size(); i += 4) Add("hatch", id, xy, i, i + 4);
  }

  absl::StatusOr<GcodeLayer> Take() && {
    if (layer_.index < layer_.layer_count) return std::move(layer_);
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     fmt::format("there is no layer {}: the last layer is {}", layer_.index,
                                 layer_.layer_count - 1));
  }

 private:
  void Add(const char* feature, int id, const std::vector<double>& xy, size_t from, size_t to) {
    if (layer_.layer_count != layer_.index + 1 || to < from + 4) return;
    BeadRun run;
    run.feature = feature;
    run.width_mm = width_mm_;
    if (const auto style = styles_.find(id); style != styles_.end()) {
      run.feature = FeatureOf(style->second, feature);
      run.speed_mm_s = style->second.speed_mm_s;
      run.energy_j_mm = style->second.EnergyJPerMm();
    }
    for (size_t i = from; i + 2 <= to; i += 2)
      run.points.push_back({xy[i] * unit_mm_, xy[i + 1] * unit_mm_});
    if (!layer_.beads.empty())
      layer_.travels.push_back({layer_.beads.back().points.back(), run.points.front()});
    layer_.beads.push_back(std::move(run));
  }

  const double unit_mm_;
  const double width_mm_;
  const std::map<int, LineStyle> styles_;
  double last_z_mm_ = 0;
  GcodeLayer layer_;
};

/// Returns a line's id; -1 for an id that no label can have.
int IdOf(double number) { return number >= 0 && number < 1e9 ? static_cast<int>(number) : -1; }

/// Returns the numbers of `a,b,c`; nothing if one is invalid.
std::optional<std::vector<double>> NumbersOf(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view item : Split(text, ",")) {
    double value = 0;
    if (!absl::SimpleAtod(absl::string_view(item.data(), item.size()), &value)) return std::nullopt;
    numbers.push_back(value);
  }
  return numbers;
}

/// Processes one `$$NAME/numbers` of the ASCII geometry.
absl::Status TakeCommand(std::string_view name, std::string_view values, LayerKeeper& keeper) {
  const size_t header = name == "POLYLINE" ? 3 : name == "HATCHES" ? 2 : 0;
  if (name != "LAYER" && header == 0) return absl::OkStatus();  // ignores labels and other commands
  const auto numbers = NumbersOf(values);
  if (!numbers || numbers->size() < std::max<size_t>(header, 1))
    return NotCli(fmt::format("$${} has no numbers", name));
  if (header == 0) {
    keeper.Layer(numbers->front());
    return absl::OkStatus();
  }
  const size_t each = name == "HATCHES" ? 4 : 2;
  const double count = (*numbers)[header - 1];
  if (static_cast<double>(numbers->size() - header) != count * static_cast<double>(each))
    return NotCli(fmt::format("$${} does not have the {} items that it announces", name, count));
  const std::vector<double> xy(numbers->begin() + static_cast<std::ptrdiff_t>(header),
                               numbers->end());
  const int id = IdOf(numbers->front());
  name == "HATCHES" ? keeper.Hatches(id, xy) : keeper.Polyline(id, xy);
  return absl::OkStatus();
}

absl::Status ReadAscii(std::string_view body, LayerKeeper& keeper) {
  for (size_t at = body.find("$$"); at != std::string_view::npos;) {
    const size_t next = body.find("$$", at + 2);
    const std::string_view command = Trim(body.substr(at + 2, next - at - 2));
    const size_t slash = command.find('/');
    const std::string_view values =
        slash == std::string_view::npos ? std::string_view() : command.substr(slash + 1);
    if (absl::Status ok = TakeCommand(command.substr(0, slash), values, keeper); !ok.ok())
      return ok;
    at = next;
  }
  return absl::OkStatus();
}

/// Reader of consecutive little-endian numbers.
class BinaryReader {
 public:
  explicit BinaryReader(std::string_view bytes) : bytes_(bytes) {}

  size_t at() const { return at_; }
  size_t left() const { return bytes_.size() - at_; }

  template <class T>
  std::optional<double> Next() {
    if (left() < sizeof(T)) return std::nullopt;
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return static_cast<double>(value);
  }

 private:
  std::string_view bytes_;
  size_t at_ = 0;
};

struct LineItems {
  int id = 0;
  std::vector<double> xy;
};

/// Reads `heads` whole numbers and the coordinates after them. The first number is an id, and the
/// last one is a count of items of `each` coordinates. Short commands have 16-bit integers. Long
/// commands have 32-bit integers and floats.
template <class Head, class Coordinate>
std::optional<LineItems> Items(BinaryReader& reader, int heads, size_t each) {
  const std::optional<double> id = reader.Next<Head>();
  std::optional<double> count = id;
  for (int i = 1; i < heads && count; ++i) count = reader.Next<Head>();
  if (!count) return std::nullopt;
  const double numbers = *count * static_cast<double>(each);
  if (numbers < 0 || numbers * sizeof(Coordinate) > static_cast<double>(reader.left()))
    return std::nullopt;
  LineItems items{IdOf(*id), {}};
  while (static_cast<double>(items.xy.size()) < numbers)
    items.xy.push_back(*reader.Next<Coordinate>());
  return items;
}

absl::Status ReadBinary(std::string_view body, LayerKeeper& keeper) {
  BinaryReader reader(body);
  while (reader.left() >= 2) {
    const size_t at = reader.at();
    const auto command = static_cast<int>(*reader.Next<uint16_t>());
    const bool layer = command == 127 || command == 128;
    const bool hatches = command == 131 || command == 132;
    if (layer) {
      const auto z = command == 127 ? reader.Next<float>() : reader.Next<uint16_t>();
      if (!z) return NotCli(fmt::format("the file ends within a layer, at byte {}", at));
      keeper.Layer(*z);
      continue;
    }
    if (command < 129 || command > 132)
      return NotCli(fmt::format("command {} at byte {} of the geometry", command, at));
    const bool is_short = command == 129 || command == 131;
    const int heads = hatches ? 2 : 3;
    const size_t each = hatches ? 4 : 2;
    const auto items = is_short ? Items<uint16_t, uint16_t>(reader, heads, each)
                                : Items<int32_t, float>(reader, heads, each);
    if (!items) return NotCli(fmt::format("the file ends within the command at byte {}", at));
    hatches ? keeper.Hatches(items->id, items->xy) : keeper.Polyline(items->id, items->xy);
  }
  return absl::OkStatus();
}

}  // namespace

bool IsCliFile(std::string_view bytes) {
  constexpr size_t kProbeBytes = 4096;
  return Trim(WithoutComments(bytes.substr(0, kProbeBytes))).starts_with(kHeaderStart);
}

absl::StatusOr<GcodeLayer> ReadCliLayer(std::string_view bytes, int index, double width_mm) {
  const size_t end = bytes.find(kHeaderEnd);
  if (!IsCliFile(bytes) || end == std::string_view::npos)
    return NotCli("the header of the file is incomplete");
  const std::string header = WithoutComments(bytes.substr(0, end));
  constexpr std::string_view kUnits = "$$UNITS/";
  double unit_mm = 0;
  const size_t units = header.find(kUnits);
  if (units != std::string_view::npos) {
    const std::string_view rest = std::string_view(header).substr(units + kUnits.size());
    const std::string_view number = Trim(rest.substr(0, rest.find_first_of("\r\n$/")));
    if (!absl::SimpleAtod(absl::string_view(number.data(), number.size()), &unit_mm)) unit_mm = 0;
  }
  if (!(unit_mm > 0)) return NotCli("the header of the file has no $$UNITS");
  LayerKeeper keeper(index, unit_mm, width_mm, StylesOf(header));
  const std::string_view body = bytes.substr(end + kHeaderEnd.size());
  const bool binary = header.find("$$BINARY") != std::string::npos;
  const absl::Status read =
      binary ? ReadBinary(body, keeper) : ReadAscii(WithoutComments(body), keeper);
  if (!read.ok()) return read;
  return std::move(keeper).Take();
}

}  // namespace slicefarm::cli
