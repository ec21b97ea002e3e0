#include "services/exposure/algo/scan/block_order.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <tuple>

#include "common/geometry/line_axes.h"
#include "common/geometry/measure.h"

namespace slicefarm::exposure {
namespace {

/// Point at which the scan of a block can begin: its start, or its end if it is reversible.
struct Entry {
  Point at;
  size_t block = 0;
  bool reversed = false;
};

/// Entries in square cells, about two per cell.
class EntryGrid {
 public:
  explicit EntryGrid(const std::vector<Entry>& entries) {
    for (const Entry& entry : entries) box_.Add(entry.at);
    const double width = static_cast<double>(box_.max.x - box_.min.x) + 1;
    const double height = static_cast<double>(box_.max.y - box_.min.y) + 1;
    cell_ = std::max(std::sqrt(width * height / static_cast<double>(entries.size() / 2 + 1)),
                     std::max(width, height) / 1000);
    columns_ = static_cast<int64_t>(width / cell_) + 1;
    rows_ = static_cast<int64_t>(height / cell_) + 1;
    cells_.resize(static_cast<size_t>(columns_ * rows_));
    for (const Entry& entry : entries)
      cells_[Index(Column(entry.at), Row(entry.at))].push_back(entry);
  }

  /// Returns the nearest entry of a block for which `is_left` is true. Removes entries of finished
  /// blocks from the visited cells.
  template <typename IsLeft>
  std::optional<Entry> Nearest(Point from, IsLeft is_left) {
    const int64_t column = Column(from), row = Row(from);
    std::optional<Entry> best;
    double least = 0;
    const auto key = [&](const Entry& entry, double distance) {
      return std::tuple(distance, entry.block, entry.reversed);
    };
    for (int64_t ring = 0; ring <= std::max(columns_, rows_); ++ring) {
      // All entries in this ring of cells are at least (ring - 1) cells away.
      if (best && least <= static_cast<double>(ring - 1) * cell_) break;
      ForRing(column, row, ring, [&](std::vector<Entry>& cell) {
        std::erase_if(cell, [&](const Entry& entry) { return !is_left(entry.block); });
        for (const Entry& entry : cell) {
          const double distance = Distance(from, entry.at);
          if (!best || key(entry, distance) < key(*best, least)) {
            best = entry;
            least = distance;
          }
        }
      });
    }
    return best;
  }

 private:
  static int64_t Clamped(double at, int64_t count) {
    return std::clamp(static_cast<int64_t>(at), int64_t{0}, count - 1);
  }
  int64_t Column(Point p) const {
    return Clamped(static_cast<double>(p.x - box_.min.x) / cell_, columns_);
  }
  int64_t Row(Point p) const {
    return Clamped(static_cast<double>(p.y - box_.min.y) / cell_, rows_);
  }
  size_t Index(int64_t column, int64_t row) const {
    return static_cast<size_t>(row * columns_ + column);
  }

  template <typename Visit>
  void ForRing(int64_t column, int64_t row, int64_t ring, Visit visit) {
    for (int64_t r = std::max<int64_t>(0, row - ring); r <= std::min(rows_ - 1, row + ring); ++r) {
      const bool whole = std::abs(r - row) == ring;
      for (int64_t c = column - ring; c <= column + ring; c += whole || ring == 0 ? 1 : 2 * ring)
        if (c >= 0 && c < columns_) visit(cells_[Index(c, r)]);
    }
  }

  Box box_;
  double cell_ = 1;
  int64_t columns_ = 1, rows_ = 1;
  std::vector<std::vector<Entry>> cells_;
};

/// Appends the blocks for which `wanted` is true to the order, nearest first.
template <typename Wanted>
void AppendNearest(const std::vector<ScanBlock>& blocks, Wanted wanted, Point from,
                   std::vector<BlockTurn>& turns) {
  std::vector<Entry> entries;
  std::vector<bool> left(blocks.size());
  size_t count = 0;
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (!wanted(blocks[i])) continue;
    entries.push_back({blocks[i].start, i, false});
    if (blocks[i].reversible) entries.push_back({blocks[i].end, i, true});
    left[i] = true;
    ++count;
  }
  if (entries.empty()) return;
  EntryGrid grid(entries);
  for (; count > 0; --count) {
    const std::optional<Entry> next = grid.Nearest(from, [&](size_t block) { return left[block]; });
    turns.push_back({next->block, next->reversed});
    left[next->block] = false;
    from = next->reversed ? blocks[next->block].start : blocks[next->block].end;
  }
}

std::vector<BlockTurn> Farthest(const std::vector<ScanBlock>& blocks, Point from) {
  std::vector<BlockTurn> turns;
  std::vector<size_t> left(blocks.size());
  for (size_t i = 0; i < left.size(); ++i) left[i] = i;
  while (!left.empty()) {
    size_t best = 0;
    for (size_t k = 1; k < left.size(); ++k)
      if (Distance(from, blocks[left[k]].start) > Distance(from, blocks[left[best]].start))
        best = k;
    turns.push_back({left[best], false});
    from = blocks[left[best]].end;
    left.erase(left.begin() + static_cast<ptrdiff_t>(best));
  }
  return turns;
}

std::vector<BlockTurn> AgainstGas(const std::vector<ScanBlock>& blocks, double gas_flow_deg) {
  const LineAxes gas = LineAxes::OfDegrees(gas_flow_deg);
  std::vector<BlockTurn> turns(blocks.size());
  for (size_t i = 0; i < blocks.size(); ++i)
    turns[i] = {i, blocks[i].reversible && gas.U(blocks[i].end) > gas.U(blocks[i].start)};
  std::ranges::stable_sort(turns, std::greater<>(),
                           [&](const BlockTurn& turn) { return gas.U(blocks[turn.block].middle); });
  return turns;
}

}  // namespace

std::vector<BlockTurn> OrderBlocks(const std::vector<ScanBlock>& blocks, JumpOrder order,
                                   Point from, double gas_flow_deg) {
  std::vector<BlockTurn> turns;
  switch (order) {
    case JumpOrder::kNearest:
      AppendNearest(
          blocks, [](const ScanBlock&) { return true; }, from, turns);
      break;
    case JumpOrder::kChequerboard:
      for (const bool odd : {false, true}) {
        AppendNearest(
            blocks, [odd](const ScanBlock& block) { return block.odd == odd; }, from, turns);
        if (!turns.empty()) from = blocks[turns.back().block].end;
      }
      break;
    case JumpOrder::kFarthest:
      return Farthest(blocks, from);
    case JumpOrder::kAgainstGas:
      return AgainstGas(blocks, gas_flow_deg);
  }
  return turns;
}

Point MiddleOf(const Box& box) {
  return {box.min.x + (box.max.x - box.min.x) / 2, box.min.y + (box.max.y - box.min.y) / 2};
}

}  // namespace slicefarm::exposure
