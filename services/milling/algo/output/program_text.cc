#include "services/milling/algo/output/program_text.h"

#include <limits>
#include <string_view>

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

std::string_view NameOf(MillingStage stage) {
  switch (stage) {
    case MillingStage::kRoughing:
      return "roughing";
    case MillingStage::kFinishing:
      return "finishing";
    case MillingStage::kRest:
      return "rest areas";
  }
  return "";
}

/// Writes moves, and of each what has changed.
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
    if (last == nullptr || last->stage != move.stage) moves.Comment(NameOf(move.stage));
    moves.Add(move);
    last = &move;
  }
  return dialect.Start(options.machining, options.tolerance_mm, program.safe_z_mm) + moves.Take() +
         dialect.End();
}

}  // namespace slicefarm::milling
