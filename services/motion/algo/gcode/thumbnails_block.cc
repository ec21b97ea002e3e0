#include "services/motion/algo/gcode/thumbnails_block.h"

#include <string_view>
#include <utility>

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
    case PictureFormat::kBtt:
    case PictureFormat::kColPic:
      break;
  }
  return "thumbnail";
}

/// Returns the tag of a picture in the format ColPic: the first one is shown in lists.
std::string_view ColPicTag(bool first) { return first ? ";gimage:" : ";simage:"; }

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
  bool first_colpic = true, any_btt = false;
  for (const Thumbnail& thumbnail : thumbnails) {
    if (thumbnail.data.empty()) continue;
    if (thumbnail.format == PictureFormat::kColPic) {
      block.append("\n").append(ColPicTag(std::exchange(first_colpic, false)));
      block.append(thumbnail.data).append("\n\n");
    } else if (thumbnail.format == PictureFormat::kBtt) {
      block += thumbnail.data;
      any_btt = true;
    } else {
      Append(thumbnail, block);
    }
  }
  if (any_btt) block += "; bigtree thumbnail end\r\n\r\n";
  return block;
}

}  // namespace slicefarm::motion
