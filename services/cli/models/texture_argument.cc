#include "services/cli/models/texture_argument.h"

#include <fmt/core.h>

#include <string>
#include <string_view>

#include "absl/strings/ascii.h"
#include "absl/strings/escaping.h"
#include "common/model/limits.h"
#include "services/cli/console/files.h"
#include "services/cli/console/model_file.h"

namespace slicefarm::cli {
namespace {

bool IsFileOf(const std::string& path, std::string_view suffix) {
  return absl::AsciiStrToLower(path).ends_with(suffix);
}

bool IsSolid(const std::string& path) {
  return IsFileOf(path, ".stl") || IsFileOf(path, ".obj") || IsFileOf(path, ".ply");
}

absl::Status AddImage(JobOptions& options, std::string_view key, const std::string& path) {
  const auto bytes = ReadFile(path, limits::MaxSettingBytes(key) / 4 * 3);
  if (!bytes.ok()) return bytes.status();
  options.sets.push_back(fmt::format("{}={}", key, absl::Base64Escape(*bytes)));
  return absl::OkStatus();
}

absl::Status AddTexture(JobOptions& options) {
  const std::string& texture = options.texture.texture;
  if (IsFileOf(texture, ".png")) return AddImage(options, "texture_image", texture);
  if (!IsSolid(texture)) {
    options.sets.push_back(fmt::format("texture={}", texture));
    return absl::OkStatus();
  }
  options.models.push_back(texture);
  options.sets.push_back(fmt::format("texture={}", NameOf(texture)));
  return absl::OkStatus();
}

}  // namespace

absl::Status TakeTexture(JobOptions& options) {
  const TextureArguments& given = options.texture;
  const bool any = !given.texture.empty() || !given.mask.empty() || !given.anchor.empty() ||
                   !given.orient.empty();
  if (!any) return absl::OkStatus();
  if (options.process != Process::kEngrave)
    return Malformed("--texture, --mask, --anchor and --orient need --machine engrave");
  if (!given.texture.empty())
    if (absl::Status added = AddTexture(options); !added.ok()) return added;
  if (!given.mask.empty())
    if (absl::Status added = AddImage(options, "mask_image", given.mask); !added.ok()) return added;
  if (!given.anchor.empty()) options.sets.push_back("anchor=" + given.anchor);
  if (!given.orient.empty()) options.sets.push_back("orient=" + given.orient);
  return absl::OkStatus();
}

}  // namespace slicefarm::cli
