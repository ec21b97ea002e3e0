#include "services/cli/job/field_files.h"

#include <fmt/core.h>
#include <png.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/model/fields/field_text.h"
#include "common/model/limits.h"
#include "services/cli/console/files.h"

namespace slicefarm::cli {
namespace {

using Json = nlohmann::json;

static_assert(std::endian::native == std::endian::little, "raw files are read as they are");

constexpr int64_t kMaxJsonBytes = 64 << 20;
constexpr int64_t kMaxRawBytes = 64 << 20;
constexpr double kSteps = 1e4;  ///< densities and shares have four digits

absl::Status NotField(const std::string& why) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed, why);
}

double Rounded(double value) { return std::round(value * kSteps) / kSteps; }

template <class T>
std::vector<double> NumbersOf(std::string_view bytes, double full) {
  std::vector<double> numbers;
  for (size_t at = 0; at + sizeof(T) <= bytes.size(); at += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof(T));
    numbers.push_back(full > 1 ? Rounded(static_cast<double>(value) / full)
                               : static_cast<double>(value));
  }
  return numbers;
}

absl::StatusOr<std::string> TextOf(const Json& json, const std::string& key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_string())
    return NotField(fmt::format("the entry '{}' must be text in quotes", key));
  return found->get<std::string>();
}

absl::StatusOr<std::vector<double>> Pair(const Json& json, const std::string& key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_array() || found->size() != 2 || !(*found)[0].is_number() ||
      !(*found)[1].is_number())
    return NotField(fmt::format("the entry '{}' must be two numbers", key));
  return found->get<std::vector<double>>();
}

/// Grey values in [0, 1], the lowest row first.
struct Picture {
  int64_t width = 0;
  int64_t height = 0;
  std::vector<double> grey;
};

absl::StatusOr<Picture> ReadPng(const std::string& bytes) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0)
    return NotField(fmt::format("is not a PNG image: {}", image.message));
  Picture picture{image.width, image.height, {}};
  const int64_t pixels = picture.width * picture.height;
  if (pixels > limits::kMaxFieldValues) {
    png_image_free(&image);
    return LimitError(Reason::kRequestTooLarge, "pixels of a field's picture",
                      limits::kMaxFieldValues, pixels);
  }
  image.format = PNG_FORMAT_GRAY;
  const png_color black = {};
  std::vector<png_byte> grey(static_cast<size_t>(pixels));
  if (png_image_finish_read(&image, &black, grey.data(), 0, nullptr) == 0)
    return NotField(fmt::format("is not a PNG image: {}", image.message));
  for (int64_t y = picture.height - 1; y >= 0; --y)
    for (int64_t x = 0; x < picture.width; ++x)
      picture.grey.push_back(grey[static_cast<size_t>(y * picture.width + x)] / 255.0);
  return picture;
}

/// Replaces the names of files in fields by their content.
class Inliner {
 public:
  Inliner(std::filesystem::path folder, FieldKind kind) : folder_(std::move(folder)), kind_(kind) {}

  absl::Status Take(Json& field) const {
    if (!field.is_object()) return absl::OkStatus();
    if (kind_ == FieldKind::kMaterials && field.contains("parts") && field["parts"].is_array()) {
      for (Json& part : field["parts"])
        if (absl::Status ok = TakeOne(part); !ok.ok()) return ok;
      return absl::OkStatus();
    }
    return TakeOne(field);
  }

 private:
  absl::Status TakeOne(Json& field) const {
    if (!field.is_object()) return absl::OkStatus();
    if (field.value("kind", Json()) == "image") return TakePicture(field);
    return field.contains("file") ? TakeRaw(field) : absl::OkStatus();
  }

  absl::StatusOr<std::pair<std::string, std::string>> Beside(const Json& field) const {
    const auto name = TextOf(field, "file");
    if (!name.ok()) return name.status();
    const std::string path = (folder_ / *name).string();
    auto bytes = ReadFile(path, kMaxRawBytes);
    if (!bytes.ok()) return bytes.status();
    return std::pair(path, *std::move(bytes));
  }

  absl::Status TakeRaw(Json& field) const {
    const auto file = Beside(field);
    if (!file.ok()) return file.status();
    const auto type = TextOf(field, "type");
    if (!type.ok()) return type.status();
    std::vector<double> numbers;
    size_t size = 1;
    if (*type == "uint8" && kind_ != FieldKind::kStress) {
      numbers = NumbersOf<uint8_t>(file->second, 255);
    } else if (*type == "uint16" && kind_ != FieldKind::kStress) {
      numbers = NumbersOf<uint16_t>(file->second, 65535);
      size = 2;
    } else if (*type == "float32") {
      numbers = NumbersOf<float>(file->second, 1);
      size = 4;
    } else {
      return NotField(fmt::format("type = '{:.60}': must be {}float32", *type,
                                  kind_ == FieldKind::kStress ? "" : "uint8, uint16 or "));
    }
    if (file->second.size() % size != 0)
      return InFile(file->first, NotField("ends within a number"));
    if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); }))
      return InFile(file->first, NotField("contains a number that is not finite"));
    field.erase("file");
    field.erase("type");
    field[kind_ == FieldKind::kStress ? "stress" : "values"] = std::move(numbers);
    return absl::OkStatus();
  }

  absl::Status TakePicture(Json& field) const {
    const auto file = Beside(field);
    if (!file.ok()) return file.status();
    const auto picture = ReadPng(file->second);
    if (!picture.ok()) return InFile(file->first, picture.status());
    const auto origin = Pair(field, "origin");
    const auto size = Pair(field, "size");
    if (!origin.ok()) return origin.status();
    if (!size.ok()) return size.status();
    double range[2] = {0, 1};
    for (const auto& [key, bound] : {std::pair("min", &range[0]), std::pair("max", &range[1])}) {
      if (!field.contains(key)) continue;
      if (!field[key].is_number()) return NotField(fmt::format("{} must be a number", key));
      *bound = field[key].get<double>();
      field.erase(key);
    }
    std::vector<double> values;
    for (const double grey : picture->grey)
      values.push_back(Rounded(range[0] + (range[1] - range[0]) * grey));
    const double dx = (*size)[0] / static_cast<double>(picture->width);
    const double dy = (*size)[1] / static_cast<double>(picture->height);
    for (const std::string_view key : {"file", "size"}) field.erase(std::string(key));
    field["kind"] = "voxels";
    field["count"] = {picture->width, picture->height, 1};
    field["origin"] = {(*origin)[0] + dx / 2, (*origin)[1] + dy / 2, 0};
    field["spacing"] = {dx, dy, 1};
    field["values"] = std::move(values);
    return absl::OkStatus();
  }

  std::filesystem::path folder_;
  FieldKind kind_;
};

template <class T>
absl::StatusOr<std::string> Canonical(const Json& json,
                                      absl::StatusOr<T> (*parse)(std::string_view),
                                      std::string (*print)(const T&)) {
  const auto field = parse(json.dump());
  if (!field.ok()) return NotField(std::string(field.status().message()));
  return print(*field);
}

absl::StatusOr<Setting> SettingOf(const Json& json, FieldKind kind) {
  absl::StatusOr<std::string> text;
  std::string key;
  switch (kind) {
    case FieldKind::kDensity:
      key = "density_field";
      text = Canonical<DensityField>(json, ParseDensityField, PrintDensityField);
      break;
    case FieldKind::kStress:
      key = "stress_field";
      text = Canonical<StressField>(json, ParseStressField, PrintStressField);
      break;
    case FieldKind::kMaterials:
      key = "material_field";
      text = Canonical<MaterialField>(json, ParseMaterialField, PrintMaterialField);
      break;
  }
  if (!text.ok()) return text.status();
  const auto size = static_cast<int64_t>(key.size() + text->size());
  if (size > limits::kMaxFieldBytes)
    return LimitError(Reason::kRequestTooLarge, "bytes of the field as text",
                      limits::kMaxFieldBytes, size);
  return Setting{key, *std::move(text), Source::kRequest};
}

}  // namespace

absl::StatusOr<Setting> ReadFieldFile(const std::string& path, FieldKind kind) {
  const auto text = ReadFile(path, kMaxJsonBytes);
  if (!text.ok()) return text.status();
  Json json = Json::parse(*text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) return InFile(path, NotField("is not JSON"));
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (absl::Status ok = Inliner(folder, kind).Take(json); !ok.ok()) return InFile(path, ok);
  auto setting = SettingOf(json, kind);
  if (!setting.ok()) return InFile(path, setting.status());
  return setting;
}

}  // namespace slicefarm::cli
