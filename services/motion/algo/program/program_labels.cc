#include "services/motion/algo/program/program_labels.h"

#include "common/base/text.h"

namespace slicefarm::motion {

bool ProgramLabels::Read(std::string_view comment) {
  comment = Trim(comment);
  for (const std::string_view tag : {"TYPE:", "FEATURE:"}) {
    if (!comment.starts_with(tag)) continue;
    feature_ = std::string(Trim(comment.substr(tag.size())));
    custom_ = feature_ == "Custom";
    return true;
  }
  if (comment != "LAYER_CHANGE" && comment != "CHANGE_LAYER" && !comment.starts_with("LAYER:"))
    return false;
  if (layer_ < 0) custom_ = false;
  ++layer_;
  return true;
}

std::optional<std::string_view> QuotedValue(std::string_view comment, std::string_view key) {
  comment = Trim(comment);
  if (!comment.starts_with(key)) return std::nullopt;
  comment = Trim(comment.substr(key.size()));
  if (!comment.starts_with('=')) return std::nullopt;
  return Trim(comment.substr(1));
}

}  // namespace slicefarm::motion
