#include "services/milling/algo/output/program_text.h"

#include <fmt/core.h>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "absl/strings/str_split.h"
#include "common/gcode/gcode_text.h"
#include "common/gcode/modal.h"

namespace slicefarm::milling {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::string_view WordOf(MoveKind kind) {
  switch (kind) {
    case MoveKind::kRapid:
      return "G0";
    case MoveKind::kLine:
      return "G1";
    case MoveKind::kClockwise:
      return "G2";
    case MoveKind::kCounterClockwise:
      return "G3";
  }
  return "";
}

std::string_view NameOf(MillPhase phase) {
  switch (phase) {
    case MillPhase::kRoughing:
      return "roughing";
    case MillPhase::kFinishing:
      return "finishing";
    case MillPhase::kRest:
      return "rest areas";
  }
  return "";
}

/// Writes moves, each with only its changed values.
class MoveText {
 public:
  explicit MoveText(double safe_z_mm) : at_{kUnknown, kUnknown, safe_z_mm} {}

  void Add(const MillMove& move) {
    const bool arc = move.kind == MoveKind::kClockwise || move.kind == MoveKind::kCounterClockwise;
    const size_t start = out_.text().size();
    if (kind_.Changes(move.kind)) out_ << WordOf(move.kind);
    for (const int axis : {0, 1, 2})
      if (move.to_mm[axis] != at_[axis] || (arc && axis < 2)) Number("XYZ"[axis], move.to_mm[axis]);
    if (arc) {
      Number('I', move.centre_mm.x() - at_.x());
      Number('J', move.centre_mm.y() - at_.y());
    }
    if (move.kind != MoveKind::kRapid && feed_.Changes(move.feed_mm_min))
      Number('F', move.feed_mm_min);
    at_ = move.to_mm;
    if (out_.text().size() > start) out_ << '\n';
  }

  void Comment(std::string_view words) { out_ << '(' << words << ")\n"; }

  std::string Take() { return out_.Take(); }

 private:
  void Number(char word, double value) {
    if (!out_.text().empty() && out_.text().back() != '\n') out_ << ' ';
    (out_ << word).Fixed(value + 0.0, 3);
  }

  GcodeText out_;
  gcode::Modal<MoveKind> kind_;
  Eigen::Vector3d at_;
  gcode::Modal<double> feed_;
};

}  // namespace

std::string ProgramText(const MillProgram& program, const MillingOptions& options,
                        const GcodeDialect& dialect) {
  MoveText moves(program.safe_z_mm);
  const MillMove* last = nullptr;
  for (const MillMove& move : program.moves) {
    if (last == nullptr || last->phase != move.phase) moves.Comment(NameOf(move.phase));
    moves.Add(move);
    last = &move;
  }
  return dialect.Start(options.machining, options.tolerance_mm, program.safe_z_mm) + moves.Take() +
         dialect.End();
}

std::string WholeProgram(const MillingJob& job, const MillProgram& program,
                         const GcodeDialect& dialect, std::string_view settings_text) {
  const Eigen::Vector3d low = job.stock_box.min(), high = job.stock_box.max();
  std::string text = fmt::format(
      "; tool {}: {}, {} rpm\n; stock: x {:.3f} to {:.3f}, y {:.3f} to {:.3f}, z {:.3f} to "
      "{:.3f}\n",
      job.options.machining.tool_number, job.options.cutter.name(),
      job.options.machining.spindle_rpm, low.x(), high.x(), low.y(), high.y(), low.z(), high.z());
  text += ProgramText(program, job.options, dialect);
  const std::vector<std::string> lines =
      absl::StrSplit(std::string(settings_text), '\n', absl::SkipEmpty());
  for (const std::string& line : lines) text += "; " + line + "\n";
  return text;
}

}  // namespace slicefarm::milling
