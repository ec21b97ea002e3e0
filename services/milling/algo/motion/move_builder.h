#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "services/milling/algo/motion/mill_move.h"
#include "services/milling/algo/motion/stock_map.h"

namespace slicefarm::milling {

/// Builder of the moves of one tool. It removes the cut stock from a StockMap. The tool begins at
/// the safe height, at an unknown x and y.
class MoveBuilder {
 public:
  /// After cancellation, the stock map is incomplete, so callers must check the token.
  explicit MoveBuilder(const MillingJob& job, const CancelToken& cancel = {});

  /// Sets the phase of the following moves.
  void SetPhase(MillPhase phase) { phase_ = phase; }

  /// Adds rapid moves to a position: up over all stock on the path, horizontally, and down to the
  /// clearance above z. If the stock at the position is higher than z, the tool stops above the
  /// stock.
  void RapidTo(const Eigen::Vector2d& place_mm, double z_mm);
  /// Adds a move up to the safe height.
  void Retract();
  /// Adds a straight move at a feed. Adds nothing if the tip already is at `to_mm`.
  void LineTo(const Eigen::Vector3d& to_mm, double feed_mm_min);
  /// Adds an arc or a helix.
  void ArcTo(const Eigen::Vector3d& to_mm, const Eigen::Vector2d& centre_mm, bool clockwise,
             double feed_mm_min);
  /// Adds feed moves along a line at the tip's present height. Uses arcs where they fit, and as few
  /// straight moves as the tolerance allows.
  void FeedAlong(std::span<const Eigen::Vector2d> line_mm, double feed_mm_min);

  /// Returns the position of the tip.
  const Eigen::Vector3d& at() const { return at_; }
  bool placed() const { return placed_; }  ///< true if x and y of `at` are known
  /// Returns the remaining stock.
  const StockMap& stock() const { return stock_; }
  /// Returns the height at which rapid moves are safe everywhere.
  double safe_z_mm() const { return safe_z_mm_; }
  /// Removes all moves from the builder and returns them.
  std::vector<MillMove> TakeMoves() { return std::move(moves_); }

 private:
  void Emit(MillMove move);

  const MillingJob& job_;
  StockMap stock_;
  double safe_z_mm_;
  MillPhase phase_ = MillPhase::kRoughing;
  bool placed_ = false;
  Eigen::Vector3d at_;
  std::vector<MillMove> moves_;
};

}  // namespace slicefarm::milling
