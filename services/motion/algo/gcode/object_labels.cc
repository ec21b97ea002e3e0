#include "services/motion/algo/gcode/object_labels.h"

#include <algorithm>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "common/geometry/measure.h"
#include "services/motion/algo/gcode/comment_text.h"

namespace slicefarm::motion {
namespace {

bool IsKlipper(const MotionOptions& options) { return options.flavor == GcodeFlavor::kKlipper; }

/// Klipper takes parameters apart at blanks, quotes and comment signs.
std::string ForKlipper(std::string name) {
  constexpr std::string_view kSpecial = " \"#%&'*-./:;<>\\=[]{}|";
  std::ranges::replace_if(name, [&](char c) { return kSpecial.find(c) != kSpecial.npos; }, '_');
  return name;
}

Point Middle(const Polygon& hull) {
  const Box box = Bounds(hull);
  return {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

void WritePoint(Point point, std::string_view between, GcodeText& out) {
  out.Real(ToMm(static_cast<double>(point.x)), 3) << between;
  out.Real(ToMm(static_cast<double>(point.y)), 3);
}

void DefineForKlipper(const CopySummary& copy, const std::string& label, GcodeText& out) {
  out << "EXCLUDE_OBJECT_DEFINE NAME=" << label;
  if (!copy.footprint.empty()) {
    out << " CENTER=";
    WritePoint(Middle(copy.footprint), ",", out);
    out << " POLYGON=";
    std::string_view before = "[[";
    for (const Point corner : copy.footprint) {
      out << before;
      WritePoint(corner, ",", out);
      before = "],[";
    }
    out << "]]";
  }
  out << '\n';
}

}  // namespace

std::string LabelOf(const CopyName& name, size_t index, const MotionOptions& options) {
  std::string label = CommentLine(name.object_name);
  if (options.labels == ObjectLabels::kComments)
    return absl::StrCat(label, " id:", name.object, " copy ", name.copy);
  if (name.copies > 1) absl::StrAppend(&label, " (Instance ", name.copy + 1, ")");
  return IsKlipper(options) ? absl::StrCat(ForKlipper(label), "-", index) : label;
}

void BeginCopy(const CopyName& name, size_t index, const MotionOptions& options, GcodeText& out) {
  if (options.labels == ObjectLabels::kNone) return;
  if (options.labels == ObjectLabels::kComments) {
    out << "; printing object " << LabelOf(name, index, options) << '\n';
  } else if (IsKlipper(options)) {
    out << "EXCLUDE_OBJECT_START NAME=" << LabelOf(name, index, options) << '\n';
  } else {
    out << "M486 S";
    out.Integer(static_cast<int64_t>(index)) << '\n';
  }
}

void EndCopy(const CopyName& name, size_t index, const MotionOptions& options, GcodeText& out) {
  if (options.labels == ObjectLabels::kNone) return;
  if (options.labels == ObjectLabels::kComments) {
    out << "; stop printing object " << LabelOf(name, index, options) << '\n';
  } else if (IsKlipper(options)) {
    out << "EXCLUDE_OBJECT_END NAME=" << LabelOf(name, index, options) << '\n';
  } else {
    out << "M486 S-1\n";
  }
}

void DefineCopies(std::span<const CopySummary> copies, const MotionOptions& options,
                  GcodeText& out) {
  if (options.labels != ObjectLabels::kFirmware) return;
  if (!IsKlipper(options)) {
    out << "M486 T";
    out.Integer(static_cast<int64_t>(copies.size())) << '\n';
  }
  for (size_t i = 0; i < copies.size(); ++i) {
    const std::string label = LabelOf(copies[i].name, i, options);
    if (IsKlipper(options)) {
      DefineForKlipper(copies[i], label, out);
      continue;
    }
    out << "M486 S";
    out.Integer(static_cast<int64_t>(i)) << "\nM486 A" << label << "\nM486 S-1\n";
  }
}

}  // namespace slicefarm::motion
