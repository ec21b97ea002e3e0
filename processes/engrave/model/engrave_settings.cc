#include "processes/engrave/model/engrave_settings.h"

#include <fmt/core.h>

#include "absl/strings/escaping.h"
#include "common/base/error.h"
#include "common/base/text.h"

namespace slicefarm {
namespace {

constexpr size_t kMostNumbers = 1000;
constexpr size_t kQuotedBytes = 80;

absl::Status Malformed(std::string_view setting, std::string_view text, std::string_view want) {
  const std::string quoted(text.substr(0, kQuotedBytes));
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("{} = '{}': {}", setting, quoted, want),
                   {{"setting", std::string(setting)}, {"value", quoted}});
}

}  // namespace

absl::StatusOr<std::vector<double>> NumbersOf(std::string_view setting, std::string_view text,
                                              size_t count) {
  std::vector<double> numbers;
  if (text.empty()) return numbers;
  const auto items = Split(text, ",");
  for (const std::string_view item : items)
    if (const auto number = ToNumber(Trim(item))) numbers.push_back(*number);
  const bool fits = count > 0 ? numbers.size() == count : numbers.size() <= kMostNumbers;
  if (fits && numbers.size() == items.size()) return numbers;
  return Malformed(setting, text,
                   count > 0 ? fmt::format("{} numbers, separated by commas, are needed", count)
                             : fmt::format("numbers, separated by commas, are needed, at most {}",
                                           kMostNumbers));
}

absl::StatusOr<std::string> ImageBytes(std::string_view setting, std::string_view base64) {
  std::string bytes;
  if (absl::Base64Unescape(absl::string_view(base64.data(), base64.size()), &bytes)) return bytes;
  return Malformed(setting, base64, "a PNG file in base64 is needed");
}

absl::Status CheckTexts(const EngraveSettings& settings) {
  const TextureSettings& texture = settings.texture;
  absl::Status status = NumbersOf("texture_pitch", texture.pitch, 2).status();
  status.Update(NumbersOf("anchor", texture.anchor, 3).status());
  status.Update(NumbersOf("orient", texture.orient, 3).status());
  status.Update(NumbersOf("spacing", settings.lines.spacing, 0).status());
  status.Update(NumbersOf("angle", settings.lines.angle, 0).status());
  status.Update(NumbersOf("centre", settings.machine.centre, 3).status());
  status.Update(ImageBytes("texture_image", texture.image).status());
  status.Update(ImageBytes("mask_image", texture.mask).status());
  return status;
}

}  // namespace slicefarm
