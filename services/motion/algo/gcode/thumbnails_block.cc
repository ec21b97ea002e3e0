#include "services/motion/algo/gcode/thumbnails_block.h"

#include <string_view>

#include "absl/strings/escaping.h"

namespace slicefarm::motion {
namespace {

constexpr size_t kCharactersPerLine = 78;

std::string TagOf(PictureFormat format) {
  switch (format) {
    case PictureFormat::kPng:
      return "thumbnail";
    case PictureFormat::kQoi:
      return "thumbnail_QOI";
    case PictureFormat::kJpg:
      return "thumbnail_JPG";
  }
  return "thumbnail";
}

void Append(const Thumbnail& thumbnail, std::string& block) {
  std::string code;
  absl::Base64Escape(absl::string_view(thumbnail.data.data(), thumbnail.data.size()), &code);
  const std::string tag = TagOf(thumbnail.format);
  block += "; " + tag + " begin " + std::to_string(thumbnail.width_px) + "x" +
           std::to_string(thumbnail.height_px) + " " + std::to_string(code.size()) + "\n";
  for (std::string_view rest = code; !rest.empty();) {
    const std::string_view line = rest.substr(0, kCharactersPerLine);
    rest.remove_prefix(line.size());
    block.append("; ").append(line).append("\n");
  }
  block += "; " + tag + " end\n;\n";
}

}  // namespace

std::string ThumbnailsBlock(const std::vector<Thumbnail>& thumbnails) {
  std::string block;
  for (const Thumbnail& thumbnail : thumbnails) {
    if (!thumbnail.data.empty()) Append(thumbnail, block);
  }
  return block;
}

}  // namespace slicefarm::motion
