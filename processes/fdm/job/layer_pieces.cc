#include "processes/fdm/job/layer_pieces.h"

#include <algorithm>
#include <array>
#include <utility>

#include "common/gcode/custom_code.h"

namespace slicefarm::coordinator {
namespace {

/// Collects the pieces of a program from its start to its end.
class Pieces {
 public:
  Pieces(std::span<const int64_t> code_at, std::span<std::string> code)
      : code_at_(code_at), code_(code.first(std::min(code.size(), code_at.size()))) {}

  /// Appends all bytes up to `end`, and the inserted code between them.
  void TakeTo(int64_t end) {
    for (; filled_ < code_.size() && code_at_[filled_] <= end; ++filled_) {
      pieces_.push_back({done_, code_at_[filled_], std::move(code_[filled_])});
      done_ = code_at_[filled_];
    }
    if (end > done_) pieces_.push_back({done_, end});
    done_ = end;
  }
  void LeaveOut(const ModeLine& line) {
    TakeTo(line.at);
    done_ = line.at + line.size;
  }
  std::vector<LayerPiece> Finish() { return std::move(pieces_); }

 private:
  const std::span<const int64_t> code_at_;
  const std::span<std::string> code_;
  size_t filled_ = 0;
  int64_t done_ = 0;
  std::vector<LayerPiece> pieces_;
};

}  // namespace

void LayerJoin::Pass(std::string_view gcode) {
  if (!gcode::LeavesModes(gcode)) set_ = {};
}

std::vector<LayerPiece> LayerJoin::PiecesOf(const LayerProgram& program, int64_t size,
                                            std::span<std::string> code) {
  const bool known = program.modes_at_end && std::ranges::all_of(code, gcode::LeavesModes);
  if (!known) set_ = {};
  Pieces pieces(program.code_at, code);
  std::array<bool, kMachineModes> sets = {};
  for (const ModeLine& line : program.mode_lines) {
    if (line.mode == MachineMode::kFilament) {
      if (line.value == (retracted_ ? kRetracted : kReady)) pieces.LeaveOut(line);
      continue;
    }
    const auto mode = static_cast<size_t>(line.mode);
    if (known && set_[mode] == line.value) pieces.LeaveOut(line);
    if (known) set_[mode] = line.value;
    sets[mode] = true;
  }
  pieces.TakeTo(size);
  retracted_ = program.ends_retracted;
  for (size_t mode = 0; known && mode < set_.size(); ++mode)
    // Without a value, a mode that the layer sets is not known at the layer's end.
    if (const std::string& value = (*program.modes_at_end)[mode]; !value.empty() || sets[mode])
      set_[mode] = value;
  return pieces.Finish();
}

}  // namespace slicefarm::coordinator
