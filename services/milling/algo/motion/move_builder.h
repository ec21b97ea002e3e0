#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "services/milling/algo/motion/mill_move.h"
#include "services/milling/algo/motion/stock_map.h"

namespace slicefarm::milling {

/// Moves of one tool, one after the other, and the stock that they leave. The tool begins somewhere
/// at the safe height.
class MoveBuilder {
 public:
  /// Once cancelled, a stock of its own is not read to its end: ask the token.
  explicit MoveBuilder(const MillingJob& job, const CancelToken& cancel = {});

  void SetPhase(MillPhase phase) { phase_ = phase; }

  /// By rapid moves: up over all stock on the way, there, and down to the clearance above z, or
  /// above what stands there if that is higher.
  void RapidTo(const Eigen::Vector2d& place_mm, double z_mm);
  /// Up to the safe height.
  void Retract();
  /// Straight, at a feed; nothing if the tip is there.
  void LineTo(const Eigen::Vector3d& to_mm, double feed_mm_min);
  /// An arc, or a helix.
  void ArcTo(const Eigen::Vector3d& to_mm, const Eigen::Vector2d& centre_mm, bool clockwise,
             double feed_mm_min);
  /// Along a line at the height of the tip, by arcs where they fit and by as few lines as the
  /// tolerance allows.
  void FeedAlong(std::span<const Eigen::Vector2d> line_mm, double feed_mm_min);

  const Eigen::Vector3d& at() const { return at_; }
  bool placed() const { return placed_; }  ///< whether `at` means a place in x and y
  const StockMap& stock() const { return stock_; }
  double safe_z_mm() const { return safe_z_mm_; }
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
