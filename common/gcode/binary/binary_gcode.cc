#include "common/gcode/binary/binary_gcode.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "common/gcode/binary/binary_format.h"
#include "common/gcode/binary/gcode_parts.h"
#include "common/gcode/binary/heatshrink.h"
#include "common/gcode/binary/meatpack.h"

namespace slicefarm::gcode {
namespace {

constexpr size_t kMostTextBytes = 65'536;  // limit on the text in a block

/// Settings and facts that printers read.
constexpr std::string_view kOfPrinter[] = {
    "printer_model",    "filament_type",   "filament_abrasive", "nozzle_diameter",
    "nozzle_high_flow", "bed_temperature", "brim_width",        "fill_density",
    "layer_height",     "temperature",     "ironing",           "support_material",
    "extruder_colour"};
constexpr std::string_view kFactsOfPrinter[] = {
    "max_layer_z",   "filament used [mm]",  "filament used [g]",
    "filament cost", "filament used [cm3]", "estimated printing time (normal mode)"};

void Append16(uint16_t value, std::string& to) {
  to += static_cast<char>(value & 0xff);
  to += static_cast<char>(value >> 8);
}
void Append32(uint32_t value, std::string& to) {
  Append16(static_cast<uint16_t>(value & 0xffff), to);
  Append16(static_cast<uint16_t>(value >> 16), to);
}

/// Block of the file. `parameters` are in the bytes of the file; `data` is not compressed yet.
struct Block {
  BlockType type;
  Compression compression = kNone;
  std::string parameters;
  std::string data;
};

absl::StatusOr<std::string> Deflate(const std::string& data) {
  uLongf size = compressBound(data.size());
  std::string bytes(size, '\0');
  const int result = compress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                              reinterpret_cast<const Bytef*>(data.data()), data.size());
  if (result != Z_OK) return absl::InternalError(fmt::format("zlib: {}", result));
  bytes.resize(size);
  return bytes;
}

absl::StatusOr<std::string> Compressed(const Block& block) {
  if (block.compression == kDeflate) return Deflate(block.data);
  return block.compression == kHeatshrink12 ? Heatshrink(block.data) : block.data;
}

absl::Status AppendBlock(const Block& block, std::string& file) {
  const auto data = Compressed(block);
  if (!data.ok()) return data.status();
  const size_t begin = file.size();
  Append16(block.type, file);
  Append16(block.compression, file);
  Append32(static_cast<uint32_t>(block.data.size()), file);
  if (block.compression != kNone) Append32(static_cast<uint32_t>(data->size()), file);
  file += block.parameters;
  file += *data;
  const auto* const bytes = reinterpret_cast<const Bytef*>(file.data() + begin);
  const uLong sum = crc32(crc32(0, nullptr, 0), bytes, static_cast<uInt>(file.size() - begin));
  Append32(static_cast<uint32_t>(sum), file);
  return absl::OkStatus();
}

std::string Parameters(std::initializer_list<uint16_t> values) {
  std::string bytes;
  for (const uint16_t value : values) Append16(value, bytes);
  return bytes;
}

Block Metadata(BlockType type, const Entries& entries, Compression compression = kNone) {
  std::string ini;
  for (const auto& [key, value] : entries) ini += key + "=" + value + "\n";
  return {type, compression, Parameters({kIni}), std::move(ini)};
}

void CopyEntries(const Entries& from, std::span<const std::string_view> keys, Entries& to) {
  for (const std::string_view key : keys) {
    const auto entry = std::ranges::find(from, key, [](const auto& e) { return e.first; });
    if (entry != from.end()) to.push_back(*entry);
  }
}

std::vector<Block> MetadataOf(GcodeParts& parts) {
  std::vector<Block> blocks;
  blocks.push_back(
      Metadata(kFileMetadata, {{"Producer", parts.producer}, {"Produced on", parts.produced_on}}));
  Entries printer;
  CopyEntries(parts.settings, kOfPrinter, printer);
  CopyEntries(parts.facts, kFactsOfPrinter, printer);
  if (!parts.objects_info.empty()) printer.emplace_back("objects_info", parts.objects_info);
  blocks.push_back(Metadata(kPrinterMetadata, printer));
  for (Picture& picture : parts.pictures) {
    blocks.push_back({kThumbnail, kNone,
                      Parameters({picture.format, picture.width_px, picture.height_px}),
                      std::move(picture.data)});
  }
  blocks.push_back(Metadata(kPrintMetadata, parts.facts));
  blocks.push_back(Metadata(kSlicerMetadata, parts.settings, kDeflate));
  return blocks;
}

/// Removes whole lines from the front of `rest`, as many as a block can hold, and returns them.
/// Returns an empty text if the first line is too long.
std::string_view TakeLines(std::string_view& rest) {
  size_t size = std::min(rest.size(), kMostTextBytes);
  if (size < rest.size()) {
    const size_t end = rest.rfind('\n', size - 1);
    size = end == std::string_view::npos ? 0 : end + 1;
  }
  const std::string_view lines = rest.substr(0, size);
  rest.remove_prefix(size);
  return lines;
}

}  // namespace

absl::StatusOr<std::string> BinaryGcode(std::string_view gcode) {
  auto parts = TakeApart(gcode);
  if (!parts.ok()) return parts.status();
  std::string file(kBinaryMagic);
  Append32(kBinaryVersion, file);
  Append16(kCrc32, file);
  for (const Block& block : MetadataOf(*parts))
    if (absl::Status added = AppendBlock(block, file); !added.ok()) return added;
  for (std::string_view rest = parts->program; !rest.empty();) {
    const std::string_view lines = TakeLines(rest);
    if (lines.empty())
      return absl::InvalidArgumentError(
          fmt::format("binary_gcode: a line has more than {} bytes", kMostTextBytes));
    const Block block{kGcode, kHeatshrink12, Parameters({kMeatPackComments}), MeatPack(lines)};
    if (absl::Status added = AppendBlock(block, file); !added.ok()) return added;
  }
  return file;
}

}  // namespace slicefarm::gcode
