#include "services/coordinator/algo/program_contents.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "absl/strings/escaping.h"
#include "common/gcode/archive/gcode_archive.h"
#include "common/gcode/binary/binary_format.h"

namespace slicefarm::coordinator {
namespace {

using ProgramJson = nlohmann::ordered_json;

constexpr size_t kMostOfLine = 256;  // longer than every line that the scan reads
constexpr std::string_view kThumbnail = "; thumbnail begin ";

/// Returns the number that the text begins with; 0 if there is none.
double NumberOf(std::string_view text) {
  double number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

bool IsMove(std::string_view line) {
  if (line.size() < 2 || line[0] != 'G' || line[1] < '0' || line[1] > '3') return false;
  return line.size() == 2 || line[2] == ' ';
}

/// Returns the line that begins at `at`, without its end. Moves `at` to the next line.
std::string_view TakeLine(std::string_view text, size_t& at) {
  const size_t end = std::min(text.find('\n', at), text.size());
  const std::string_view line = text.substr(at, end - at);
  at = std::min(end + 1, text.size());
  return line;
}

/// Returns the Base64 text after `; thumbnail begin WxH BYTES`, up to the end mark.
std::string Base64At(std::string_view text, size_t& at) {
  std::string base64;
  while (at < text.size()) {
    std::string_view line = TakeLine(text, at);
    if (line.starts_with("; thumbnail end")) break;
    if (line.starts_with("; ")) line.remove_prefix(2);
    base64 += line;
  }
  return base64;
}

/// Returns width times height of a text "WxH"; 0 if the text is no size.
int64_t AreaOf(std::string_view size) {
  int64_t width = 0;
  int64_t height = 0;
  const char* const end = size.data() + size.size();
  const auto read = std::from_chars(size.data(), end, width);
  if (read.ptr == end || *read.ptr != 'x') return 0;
  std::from_chars(read.ptr + 1, end, height);
  return width * height;
}

/// Returns the largest PNG of binary G-code. The data after the pictures may be missing.
std::optional<std::string> LargestPicture(std::string_view beginning) {
  std::optional<std::string> largest;
  int64_t largest_area = 0;
  gcode::BinaryGcodeReader reader([&](const gcode::BinaryBlock& block) {
    const int64_t area = int64_t{block.parameters[1]} * block.parameters[2];
    constexpr uint16_t kPng = 0;
    const bool is_png = block.type == gcode::kThumbnail && block.parameters[0] == kPng;
    if (is_png && area > largest_area) {
      largest_area = area;
      largest = block.data;
    }
    return absl::OkStatus();
  });
  if (!reader.Add(beginning).ok()) return std::nullopt;
  return largest;
}

/// Returns the largest PNG of a .gcode.3mf archive. Its pictures are its first members and not
/// compressed, so the data after them may be missing.
std::optional<std::string> LargestPictureOfArchive(std::string_view beginning) {
  constexpr std::string_view kMark = "PK\x03\x04";
  constexpr size_t kHeader = 30, kMethodAt = 8, kSizeAt = 18, kNameSizeAt = 26, kExtraSizeAt = 28;
  const auto number = [&](size_t at, size_t bytes) {
    size_t value = 0;
    for (size_t i = bytes; i-- > 0;)
      value = value << 8 | static_cast<unsigned char>(beginning[at + i]);
    return value;
  };
  std::string_view largest;
  for (size_t at = 0; at + kHeader <= beginning.size() && beginning.substr(at, 4) == kMark;) {
    const size_t size = number(at + kSizeAt, 4), name_size = number(at + kNameSizeAt, 2);
    const size_t data = at + kHeader + name_size + number(at + kExtraSizeAt, 2);
    if (data > beginning.size() || size > beginning.size() - data) break;
    const std::string_view name = beginning.substr(at + kHeader, name_size);
    const bool shown = name.starts_with("Metadata/plate_") && name.ends_with(".png") &&
                       name.find("no_light") == name.npos && number(at + kMethodAt, 2) == 0;
    if (shown && size > largest.size()) largest = beginning.substr(data, size);
    at = data + size;
  }
  return largest.empty() ? std::nullopt : std::optional<std::string>(largest);
}

ProgramJson ParsedReport(const std::string& report) {
  ProgramJson json = ProgramJson::parse(report, nullptr, /*allow_exceptions=*/false);
  return json.is_object() ? json : ProgramJson::object();
}

}  // namespace

void LayerScan::Line(std::string_view line, int64_t offset) {
  if (line.starts_with(";LAYER_CHANGE")) {
    layers_.push_back({.offset = block_at_ >= 0 ? block_at_ : offset});
  } else if (layers_.empty()) {
    return;
  } else if (line.starts_with(";Z:")) {
    layers_.back().z_mm = NumberOf(line.substr(3));
  } else if (line.starts_with(";HEIGHT:")) {
    if (layers_.back().height_mm == 0) layers_.back().height_mm = NumberOf(line.substr(8));
  } else if (IsMove(line)) {
    ++layers_.back().moves;
  }
}

void LayerScan::Add(std::string_view bytes) {
  if (!std::exchange(begun_, begun_ || !bytes.empty()) && gcode::IsBinaryGcode(bytes))
    binary_.emplace([this](const gcode::BinaryBlock& block) { return TakeBlock(block); });
  if (!binary_) return AddText(bytes);
  if (read_.ok()) read_ = binary_->Add(bytes);
}

absl::Status LayerScan::TakeBlock(const gcode::BinaryBlock& block) {
  if (block.type != gcode::kGcode) return absl::OkStatus();
  const auto text = gcode::TextOf(block);
  if (!text.ok()) return text.status();
  block_at_ = block.offset;
  AddText(*text);
  return absl::OkStatus();
}

void LayerScan::AddText(std::string_view bytes) {
  while (!bytes.empty()) {
    const size_t end = bytes.find('\n');
    const std::string_view part = bytes.substr(0, end);
    const bool whole = end != std::string_view::npos;
    if (whole && line_.empty()) {
      Line(part, line_at_);
    } else {
      line_.append(part.substr(0, kMostOfLine - std::min(line_.size(), kMostOfLine)));
      if (whole) Line(line_, line_at_);
      if (whole) line_.clear();
    }
    const size_t taken = whole ? end + 1 : bytes.size();
    offset_ += static_cast<int64_t>(taken);
    if (whole) line_at_ = offset_;
    bytes.remove_prefix(taken);
  }
}

std::vector<ProgramLayer> LayerScan::Layers() && {
  if (!line_.empty()) Line(line_, line_at_);
  if (!read_.ok() || (binary_ && !binary_->End().ok())) layers_.clear();
  return std::move(layers_);
}

std::string LayersJson(const std::vector<ProgramLayer>& layers,
                       const std::vector<double>& times_s) {
  ProgramJson list = ProgramJson::array();
  for (size_t i = 0; i < layers.size(); ++i) {
    const ProgramLayer& layer = layers[i];
    ProgramJson json = {{"offset", layer.offset},
                        {"z_mm", layer.z_mm},
                        {"height_mm", layer.height_mm},
                        {"moves", layer.moves}};
    if (times_s.size() == layers.size()) json["time_s"] = times_s[i];
    list.push_back(std::move(json));
  }
  return ProgramJson{{"layers", std::move(list)}}.dump() + "\n";
}

std::optional<std::string> LargestThumbnail(std::string_view beginning) {
  if (gcode::IsBinaryGcode(beginning)) return LargestPicture(beginning);
  if (gcode::IsGcodeArchive(beginning)) return LargestPictureOfArchive(beginning);
  std::optional<std::string> largest;
  int64_t largest_area = 0;
  for (size_t at = 0; at < beginning.size();) {
    const std::string_view line = TakeLine(beginning, at);
    if (!line.starts_with(kThumbnail)) continue;
    const int64_t area = AreaOf(line.substr(kThumbnail.size()));
    std::string bytes;
    if (!absl::Base64Unescape(Base64At(beginning, at), &bytes) || area <= largest_area) continue;
    largest_area = area;
    largest = std::move(bytes);
  }
  return largest;
}

std::vector<double> LayerTimesOf(const std::string& report) {
  const ProgramJson json = ParsedReport(report);
  std::vector<double> times_s;
  const auto times = json.find("times");
  if (times == json.end() || !times->is_object() || !times->contains("layers_s")) return times_s;
  for (const ProgramJson& time : (*times)["layers_s"])
    times_s.push_back(time.is_number() ? time.get<double>() : 0);
  return times_s;
}

std::string ProgramName(const std::string& report, const std::string& job_id) {
  const ProgramJson json = ParsedReport(report);
  const auto name = json.find("file_name");
  const bool given = name != json.end() && name->is_string() && !name->empty();
  const std::string text = given ? name->get<std::string>() : std::string();
  const bool plain = !text.empty() && text.find_first_of("/\\") == std::string::npos;
  return plain ? text : job_id + ".gcode";
}

std::string_view MediaTypeOf(std::string_view file_name) {
  constexpr std::pair<std::string_view, std::string_view> kTypes[] = {
      {".gcode", "text/x.gcode"}, {".nc", "text/x.gcode"},   {".csv", "text/csv"},
      {".svg", "image/svg+xml"},  {".dxf", "image/vnd.dxf"}, {".stl", "model/stl"},
      {".obj", "model/obj"},      {".cli", "text/plain"},    {".json", "application/json"},
      {".png", "image/png"},      {".3mf", "model/3mf"}};
  for (const auto& [ending, type] : kTypes)
    if (file_name.ends_with(ending)) return type;
  return "application/octet-stream";
}

}  // namespace slicefarm::coordinator
