#include "services/motion/algo/toolpath/flow_smoothing.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "common/base/portable_math.h"
#include "common/gcode/gcode_text.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

/// Piece of a bead. Flows are squared, in (mm^3/s)^2.
struct Piece {
  size_t move = 0;
  double volume_mm3 = 0;
  double asked_q2 = 0;
  double q2 = 0;
};

class Smoother {
 public:
  Smoother(const FlowSlopes& slopes, double filament_mm2, const Toolpath& path)
      : slopes_(slopes), filament_mm2_(filament_mm2), path_(path) {}

  std::vector<Move> Smoothed() {
    const std::vector<Move>& moves = path_.moves;
    for (size_t i = 0; i < moves.size();) {
      size_t end = i;
      while (end < moves.size() && IsLimited(moves[end])) ++end;
      if (end - i > 1) {
        Smooth(i, end);
      } else {
        end = i + 1;
        out_.push_back(moves[i]);
      }
      i = end;
    }
    return std::move(out_);
  }

 private:
  bool IsLimited(const Move& move) const {
    if (move.kind != MoveKind::kPrint) return false;
    return !slopes_.outer_walls || move.feature == Feature::kExternalPerimeter ||
           move.feature == Feature::kOverhangPerimeter;
  }

  void Smooth(size_t first, size_t last) {
    pieces_.clear();
    for (size_t i = first; i < last; ++i) Cut(i);
    const auto limit = [](double& q2, double from_q2, double slope, double volume) {
      if (slope > 0) q2 = std::min(q2, from_q2 + 2 * slope * volume);
    };
    for (size_t i = 1; i < pieces_.size(); ++i)
      limit(pieces_[i].q2, pieces_[i - 1].q2, slopes_.rise_mm3_s2, pieces_[i].volume_mm3);
    for (size_t i = pieces_.size() - 1; i-- > 0;)
      limit(pieces_[i].q2, pieces_[i + 1].q2, slopes_.fall_mm3_s2, pieces_[i].volume_mm3);
    for (size_t i = 0; i < pieces_.size();) {
      size_t end = i;
      while (end < pieces_.size() && pieces_[end].move == pieces_[i].move) ++end;
      Write(std::span(pieces_).subspan(i, end - i));
      i = end;
    }
  }

  void Cut(size_t i) {
    const Move& before = path_.moves[i - 1];
    const Move& move = path_.moves[i];
    const double length_mm =
        Hypot(move.x_um - before.x_um, move.y_um - before.y_um) / static_cast<double>(kUmPerMm);
    const double volume = static_cast<double>(move.filament) / kFilamentUnitsPerMm * filament_mm2_;
    const double flow = volume * SpeedOf(move.feed_rate) / length_mm;
    const auto count = std::max<int64_t>(1, std::llround(length_mm / slopes_.piece_mm));
    const Piece piece = {i, volume / static_cast<double>(count), flow * flow, flow * flow};
    pieces_.insert(pieces_.end(), static_cast<size_t>(count), piece);
  }

  /// Writes all pieces of one move. Pieces of the same speed become one.
  void Write(std::span<const Piece> pieces) {
    const Move& before = path_.moves[pieces.front().move - 1];
    const Move& move = path_.moves[pieces.front().move];
    const auto count = std::ssize(pieces);
    int32_t pushed = 0;
    for (int64_t i = 0; i < count; ++i) {
      Move piece = move;
      const Piece& asked = pieces[static_cast<size_t>(i)];
      piece.feed_rate = FeedRateOf(asked);
      if (i + 1 < count && FeedRateOf(pieces[static_cast<size_t>(i + 1)]) == piece.feed_rate)
        continue;
      const auto share = [&](int32_t from, int32_t to) {
        return static_cast<int32_t>(from + (int64_t{to} - from) * (i + 1) / count);
      };
      piece.x_um = share(before.x_um, move.x_um);
      piece.y_um = share(before.y_um, move.y_um);
      piece.filament = share(0, move.filament) - pushed;
      const Move& last = out_.back();
      const bool stays = piece.x_um == last.x_um && piece.y_um == last.y_um;
      const bool ends = i + 1 == count;
      if (!ends && (stays || piece.filament < 1 || pushed + piece.filament == move.filament))
        continue;
      pushed += piece.filament;
      out_.push_back(piece);
    }
  }

  int32_t FeedRateOf(const Piece& piece) const {
    return FeedRate(SpeedOf(path_.moves[piece.move].feed_rate) *
                    std::sqrt(piece.q2 / piece.asked_q2));
  }

  const FlowSlopes slopes_;
  const double filament_mm2_;
  const Toolpath& path_;
  std::vector<Piece> pieces_;
  std::vector<Move> out_;
};

}  // namespace

void SmoothFlow(const FlowSlopes& slopes, double filament_mm2, Toolpath& path) {
  path.moves = Smoother(slopes, filament_mm2, path).Smoothed();
}

}  // namespace slicefarm::motion
