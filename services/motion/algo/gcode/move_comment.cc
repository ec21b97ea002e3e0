#include "services/motion/algo/gcode/move_comment.h"

#include <algorithm>
#include <array>

namespace slicefarm::motion {
namespace {

/// Comments for a printed feature and for the travel to it.
struct MoveWords {
  std::string_view bead;
  std::string_view approach;
};

constexpr MoveWords kWall = {"perimeter", "move to first perimeter point"};
constexpr MoveWords kInfill = {"infill", "move to first infill point"};
constexpr MoveWords kSkirt = {"skirt", "move to first skirt point"};
constexpr MoveWords kSupport = {"support material", "move to first support material point"};
constexpr MoveWords kInterface = {"support material interface",
                                  "move to first support material interface point"};
constexpr MoveWords kIroning = {"ironing", "move to first ironing point"};

/// Comments by Feature.
constexpr std::array<MoveWords, kFeatureCount> kCommentWords = {
    kWall,   kWall,  kWall,    kInfill,    kInfill,  kInfill, kInfill,
    kInfill, kSkirt, kSupport, kInterface, kIroning, kInfill, kInfill,
};

const MoveWords& WordsFor(const Move& bead) {
  return kCommentWords[static_cast<size_t>(bead.feature)];
}

std::string_view OnTravel(const Toolpath& path, size_t index) {
  const auto bead =
      std::find_if(path.moves.begin() + static_cast<std::ptrdiff_t>(index), path.moves.end(),
                   [](const Move& move) { return move.kind == MoveKind::kPrint; });
  return bead == path.moves.end() ? "move on" : WordsFor(*bead).approach;
}

}  // namespace

std::string_view CommentOn(const Toolpath& path, size_t index) {
  const Move& move = path.moves[index];
  switch (move.kind) {
    case MoveKind::kPrint:
      return WordsFor(move).bead;
    case MoveKind::kTravel:
      return OnTravel(path, index);
    case MoveKind::kRetract:
      return "retract";
    case MoveKind::kWipe:
      return "wipe and retract";
    case MoveKind::kRestart:
      return "unretract";
    case MoveKind::kLift: {
      const int32_t before_um = index > 0 ? path.moves[index - 1].z_um : path.start_z_um;
      return move.z_um > before_um ? "lift Z" : "restore layer Z";
    }
  }
  return {};
}

}  // namespace slicefarm::motion
