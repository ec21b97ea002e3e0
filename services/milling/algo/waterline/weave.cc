#include "services/milling/algo/waterline/weave.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

namespace slicefarm::milling {
namespace {

/// Consecutive nodes of a row that are gouged.
struct Run {
  int32_t first = 0;
  int32_t last = 0;
};

/// End of a column's interval, with the index of the row below it.
struct ColumnEnd {
  int32_t row = 0;
  int32_t column = 0;
  double y = 0;
  Source source;
  bool high = false;
};

/// Crossing on the boundary of a cell.
struct CellCrossing {
  int32_t cell = 0;
  int32_t side = 0;  ///< 0 to 3: bottom, right, top, left
  double order = 0;  ///< position along the side; ascends counter-clockwise around the cell
  uint32_t crossing = 0;
  /// true if, counter-clockwise around the cell, a gouged part of its boundary ends at this
  /// crossing
  bool leaves = false;
};

/// Returns the first node above a coordinate.
int32_t NodeAbove(const FiberGrid& grid, double place) {
  auto node = static_cast<int32_t>(
      std::clamp(std::floor((place - grid.first_mm) / grid.pitch_mm), 0.0, grid.count - 1.0));
  while (node > 0 && grid.At(node - 1) > place) --node;
  while (node < grid.count && grid.At(node) <= place) ++node;
  return node;
}

/// Returns the last node below a coordinate.
int32_t NodeBelow(const FiberGrid& grid, double place) {
  int32_t node = NodeAbove(grid, place) - 1;
  while (node >= 0 && grid.At(node) >= place) --node;
  return node;
}

bool HasNode(const std::vector<Run>& runs, int32_t node) {
  const auto run =
      std::partition_point(runs.begin(), runs.end(), [&](const Run& r) { return r.last < node; });
  return run != runs.end() && run->first <= node;
}

/// Returns the ends of all columns' intervals, by row, then column, then y.
std::vector<ColumnEnd> ColumnEndsOf(const Weave& weave) {
  std::vector<ColumnEnd> ends;
  for (int32_t column = 0; column < weave.x.count; ++column) {
    for (const Interval& i : weave.columns[static_cast<size_t>(column)]) {
      ends.push_back({NodeAbove(weave.y, i.low) - 1, column, i.low, i.low_source, false});
      ends.push_back({NodeBelow(weave.y, i.high), column, i.high, i.high_source, true});
    }
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const ColumnEnd& a, const ColumnEnd& b) { return a.row < b.row; });
  return ends;
}

class Weaver {
 public:
  Weaver(const Weave& weave, const GougedAt& gouged_at)
      : weave_(weave), gouged_at_(gouged_at), column_ends_(ColumnEndsOf(weave)) {}

  std::vector<WovenLoop> Loops() {
    Row below = RowOf(0);
    for (int32_t row = 1; row < weave_.y.count; ++row) {
      Row above = RowOf(row);
      LinkStrip(row - 1, below, above);
      below = std::move(above);
    }
    return Traced();
  }

 private:
  struct Row {
    std::vector<Run> runs;
    uint32_t first_crossing = 0;
    std::vector<int32_t> cells;  ///< cells of its crossings, low and high ends alternately
  };

  uint32_t AddCrossing(const Crossing& crossing) {
    crossings_.push_back(crossing);
    next_.push_back(0);
    return static_cast<uint32_t>(crossings_.size() - 1);
  }

  Row RowOf(int32_t row) {
    const double y = weave_.y.At(row);
    Row result{.runs = {}, .first_crossing = static_cast<uint32_t>(crossings_.size()), .cells = {}};
    for (const Interval& i : weave_.rows[static_cast<size_t>(row)]) {
      const int32_t first = NodeAbove(weave_.x, i.low), last = NodeBelow(weave_.x, i.high);
      if (first <= last) result.runs.push_back({first, last});
      AddCrossing({i.low, y, i.low_source, FiberAxis::kX, row, false});
      AddCrossing({i.high, y, i.high_source, FiberAxis::kX, row, true});
      result.cells.push_back(first - 1);
      result.cells.push_back(last);
    }
    return result;
  }

  void AddRow(const Row& row, bool bottom) {
    for (size_t k = 0; k < row.cells.size(); ++k) {
      const uint32_t crossing = row.first_crossing + static_cast<uint32_t>(k);
      const Crossing& c = crossings_[crossing];
      strip_.push_back(
          {row.cells[k], bottom ? 0 : 2, bottom ? c.x : -c.x, crossing, c.high == bottom});
    }
  }

  void AddOnColumn(int32_t column, double y, const Source& source, bool high) {
    const uint32_t crossing =
        AddCrossing({weave_.x.At(column), y, source, FiberAxis::kY, column, high});
    strip_.push_back({column - 1, 1, y, crossing, high});
    strip_.push_back({column, 3, -y, crossing, !high});
  }

  /// Adds a column's interval ends between two rows, if they are consistent with the states (gouged
  /// or free) of the nodes below and above them. Otherwise adds nothing and returns false.
  bool AddEnds(std::span<const ColumnEnd> ends, bool lower, bool upper) {
    bool state = lower;
    for (const ColumnEnd& end : ends) {
      if (end.high != state) return false;
      state = !state;
    }
    if (state != upper) return false;
    for (const ColumnEnd& end : ends) AddOnColumn(end.column, end.y, end.source, end.high);
    return true;
  }

  /// Adds one crossing on a column between two rows. The rows require a crossing there, but the
  /// column's intervals disagree because of rounding.
  void AddRounded(int32_t column, int32_t row, bool high) {
    const auto& intervals = weave_.columns[static_cast<size_t>(column)];
    const double from = weave_.y.At(row), to = weave_.y.At(row + 1), free = high ? to : from;
    double best = std::numeric_limits<double>::infinity(), y = free;
    Source source;
    for (const Interval& i : intervals) {
      const double end = high ? i.high : i.low, off = std::abs(end - std::clamp(end, from, to));
      if (off < best) best = off, y = end, source = high ? i.high_source : i.low_source;
    }
    AddOnColumn(column, std::clamp(y, from, to), source, high);
  }

  void AddColumns(int32_t row, const std::vector<Run>& below, const std::vector<Run>& above) {
    Differences(below, above);
    size_t difference = 0;
    while (true) {
      const bool ends_left = next_end_ < column_ends_.size() && column_ends_[next_end_].row <= row;
      if (!ends_left && difference == differences_.size()) return;
      int32_t column = ends_left ? column_ends_[next_end_].column : weave_.x.count;
      if (difference < differences_.size()) column = std::min(column, differences_[difference]);
      if (difference < differences_.size() && differences_[difference] == column) ++difference;
      const size_t begin = next_end_;
      while (next_end_ < column_ends_.size() && column_ends_[next_end_].row <= row &&
             column_ends_[next_end_].column == column)
        ++next_end_;
      const bool lower = HasNode(below, column), upper = HasNode(above, column);
      const auto ends = std::span(column_ends_).subspan(begin, next_end_ - begin);
      if (!AddEnds(ends, lower, upper) && lower != upper) AddRounded(column, row, lower);
    }
  }

  /// Finds the columns at which two rows have different node states, ascending.
  void Differences(const std::vector<Run>& below, const std::vector<Run>& above) {
    differences_.clear();
    for (const auto& [runs, others] : {std::pair(&below, &above), std::pair(&above, &below)})
      for (const Run& run : *runs)
        for (int32_t node = run.first; node <= run.last; node = Next(*others, node, run.last)) {
        }
    std::sort(differences_.begin(), differences_.end());
  }

  /// Adds the nodes from `node` on that are in no run of `others`, up to the next run of `others`
  /// or to `last`. Returns the next node to check.
  int32_t Next(const std::vector<Run>& others, int32_t node, int32_t last) {
    const auto other = std::partition_point(others.begin(), others.end(),
                                            [&](const Run& r) { return r.last < node; });
    if (other != others.end() && other->first <= node) return other->last + 1;
    const int32_t end = other == others.end() ? last : std::min(last, other->first - 1);
    for (int32_t k = node; k <= end; ++k) differences_.push_back(k);
    return end + 1;
  }

  void LinkStrip(int32_t row, const Row& below, const Row& above) {
    strip_.clear();
    AddRow(below, true);
    AddRow(above, false);
    AddColumns(row, below.runs, above.runs);
    std::sort(strip_.begin(), strip_.end(), [](const CellCrossing& a, const CellCrossing& b) {
      return std::tie(a.cell, a.side, a.order) < std::tie(b.cell, b.side, b.order);
    });
    for (size_t begin = 0, end = 0; begin < strip_.size(); begin = end) {
      while (end < strip_.size() && strip_[end].cell == strip_[begin].cell) ++end;
      LinkCell(std::span(strip_).subspan(begin, end - begin));
    }
  }

  void LinkCell(std::span<const CellCrossing> cell) {
    // If the cell has two crossings, each is linked to the other. If it has more, a link to the
    // next crossing separates the free parts, and a link to the previous one separates the gouged
    // parts.
    const bool joined = cell.size() < 4 || MiddleGouged(cell);
    for (size_t k = 0; k < cell.size(); ++k) {
      if (!cell[k].leaves) continue;
      const size_t to = (k + (joined ? 1 : cell.size() - 1)) % cell.size();
      next_[cell[k].crossing] = cell[to].crossing;
    }
  }

  /// Returns true if the middle of the cell's crossings is gouged. Each crossing ends one free
  /// part, so this is also the middle of the cell's free parts.
  bool MiddleGouged(std::span<const CellCrossing> cell) const {
    double x = 0, y = 0;
    for (const CellCrossing& c : cell) x += crossings_[c.crossing].x, y += crossings_[c.crossing].y;
    const auto count = static_cast<double>(cell.size());
    return gouged_at_(x / count, y / count);
  }

  std::vector<WovenLoop> Traced() const {
    std::vector<WovenLoop> loops;
    std::vector<uint8_t> seen(crossings_.size(), 0);
    for (uint32_t start = 0; start < crossings_.size(); ++start) {
      if (seen[start]) continue;
      WovenLoop loop;
      for (uint32_t at = start; !seen[at]; at = next_[at]) {
        seen[at] = 1;
        const Crossing& c = crossings_[at];
        if (loop.empty() || loop.back().x != c.x || loop.back().y != c.y) loop.push_back(c);
      }
      while (loop.size() > 1 && loop.back().x == loop.front().x && loop.back().y == loop.front().y)
        loop.pop_back();
      if (loop.size() > 2) loops.push_back(std::move(loop));
    }
    return loops;
  }

  const Weave& weave_;
  const GougedAt& gouged_at_;
  std::vector<Crossing> crossings_;
  std::vector<uint32_t> next_;  ///< next crossing of each crossing
  std::vector<ColumnEnd> column_ends_;
  size_t next_end_ = 0;
  std::vector<CellCrossing> strip_;
  std::vector<int32_t> differences_;
};

}  // namespace

std::vector<WovenLoop> WeaveLoops(const Weave& weave, const GougedAt& gouged_at) {
  return Weaver(weave, gouged_at).Loops();
}

}  // namespace slicefarm::milling
