#include "services/motion/algo/gcode/object_labels.h"

#include <vector>

#include "absl/strings/str_cat.h"
#include "common/model/options/motion_options.h"
#include "common/model/scene/mesh.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/text/comment_text.h"

namespace slicefarm::motion {
std::string LabelOf(const CopyName& name, size_t index, const MotionOptions& options) {
  std::string label = CommentLine(name.object_name);
  if (options.labels == ObjectLabels::kComments)
    return absl::StrCat(label, " id:", name.object, " copy ", name.copy);
  if (name.copies > 1) absl::StrAppend(&label, " (Instance ", name.copy + 1, ")");
  // An archive names copies by their ids in its pictures.
  const size_t number =
      options.writing.archive ? static_cast<size_t>(PickId(static_cast<int32_t>(index))) : index;
  return FirmwareOf(options.flavor).LabelOf(label, number);
}

bool LabelIsAroundAll(size_t copies, const MotionOptions& options) {
  return copies == 1 && options.labels == ObjectLabels::kFirmware &&
         FirmwareOf(options.flavor).LabelsLast();
}

void BeginCopy(const CopyName& name, size_t index, const MotionOptions& options, GcodeText& out) {
  if (options.labels == ObjectLabels::kNone) return;
  if (options.labels == ObjectLabels::kComments) {
    out << "; printing object " << LabelOf(name, index, options) << '\n';
  } else {
    FirmwareOf(options.flavor).BeginCopy(LabelOf(name, index, options), index, out);
  }
}

void EndCopy(const CopyName& name, size_t index, const MotionOptions& options, GcodeText& out) {
  if (options.labels == ObjectLabels::kNone) return;
  if (options.labels == ObjectLabels::kComments) {
    out << "; stop printing object " << LabelOf(name, index, options) << '\n';
  } else {
    FirmwareOf(options.flavor).EndCopy(LabelOf(name, index, options), index, out);
  }
}

void DefineCopies(std::span<const CopySummary> copies, const MotionOptions& options,
                  GcodeText& out) {
  if (options.labels != ObjectLabels::kFirmware) return;
  std::vector<std::string> labels;
  labels.reserve(copies.size());
  for (size_t i = 0; i < copies.size(); ++i) labels.push_back(LabelOf(copies[i].name, i, options));
  FirmwareOf(options.flavor).DefineCopies(copies, labels, out);
}

}  // namespace slicefarm::motion
