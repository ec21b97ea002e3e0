#include "services/milling/algo/push/fiber_push.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>

#include "common/base/parallel.h"

namespace slicefarm::milling {
namespace {

constexpr int32_t kFibersOfBlock = 16;
/// Margin by which intervals of the level above are shortened. It is larger than any rounding, so
/// the ends always come from contacts on the current level.
constexpr double kKnownMarginMm = 1e-6;

struct TriangleBox {
  double along_low = 0, along_high = 0;
  double across_low = 0, across_high = 0;
  double bottom = 0, top = 0;
};

TriangleBox BoxOf(const FiberFrame& frame, uint32_t triangle) {
  const auto& corners = frame.mesh().triangles[triangle];
  const FiberPoint p = frame.At(corners[0], {});
  TriangleBox box{p.along, p.along, p.across, p.across, p.height, p.height};
  for (int k = 1; k < 3; ++k) {
    const FiberPoint q = frame.At(corners[k], {});
    box.along_low = std::min(box.along_low, q.along);
    box.along_high = std::max(box.along_high, q.along);
    box.across_low = std::min(box.across_low, q.across);
    box.across_high = std::max(box.across_high, q.across);
    box.bottom = std::min(box.bottom, q.height);
    box.top = std::max(box.top, q.height);
  }
  return box;
}

/// Triangles that the cutter may touch from each block of fibers, indexed by block; in each block
/// sorted by their tops, the highest first.
class TriangleBlocks {
 public:
  TriangleBlocks(const std::vector<TriangleBox>& boxes, const FiberGrid& grid, double reach_mm)
      : grid_(grid), reach_mm_(reach_mm) {
    std::vector<uint32_t> order(boxes.size());
    for (uint32_t t = 0; t < order.size(); ++t) order[t] = t;
    std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
      return boxes[a].top != boxes[b].top ? boxes[a].top > boxes[b].top : a < b;
    });
    starts_.assign(static_cast<size_t>(count()) + 1, 0);
    for (const TriangleBox& box : boxes)
      ForEachBlock(box, [&](int32_t block) { ++starts_[static_cast<size_t>(block) + 1]; });
    for (size_t block = 1; block < starts_.size(); ++block) starts_[block] += starts_[block - 1];
    triangles_.resize(starts_.back());
    std::vector<size_t> next(starts_.begin(), starts_.end() - 1);
    for (const uint32_t t : order)
      ForEachBlock(boxes[t], [&](int32_t block) { triangles_[next[block]++] = t; });
  }

  int32_t count() const { return (grid_.count + kFibersOfBlock - 1) / kFibersOfBlock; }
  std::span<const uint32_t> Of(size_t block) const {
    return std::span(triangles_).subspan(starts_[block], starts_[block + 1] - starts_[block]);
  }

 private:
  template <typename Visit>
  void ForEachBlock(const TriangleBox& box, Visit visit) const {
    const int32_t first = BlockAt(box.across_low - reach_mm_),
                  last = BlockAt(box.across_high + reach_mm_);
    for (int32_t block = first; block <= last; ++block) visit(block);
  }
  int32_t BlockAt(double across) const {
    const double fiber = (across - grid_.first_mm) / grid_.pitch_mm;
    return static_cast<int32_t>(std::clamp(fiber, 0.0, grid_.count - 1.0)) / kFibersOfBlock;
  }

  FiberGrid grid_;
  double reach_mm_;
  std::vector<size_t> starts_;
  std::vector<uint32_t> triangles_;
};

/// Results of PushSide for the mesh's edges on the current fiber. Each edge is computed once.
class EdgeMemory {
 public:
  explicit EdgeMemory(size_t edges) : known_(edges), reaches_(edges) {}

  void NextFiber() { ++fiber_; }
  const Reach& Of(const FiberFrame& frame, const Cutter& cutter, uint32_t edge,
                  const Fiber& fiber) {
    if (known_[edge] != fiber_) {
      known_[edge] = fiber_;
      reaches_[edge] = frame.PushSide(cutter, edge, fiber);
    }
    return reaches_[edge];
  }

 private:
  std::vector<uint64_t> known_;  ///< index of the fiber for which each edge was computed last
  std::vector<Reach> reaches_;
  uint64_t fiber_ = 0;
};

/// Returns the intersection of two unions of intervals.
std::vector<Interval> Intersection(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  std::vector<Interval> both;
  for (size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    const double low = std::max(a[i].low, b[k].low), high = std::min(a[i].high, b[k].high);
    if (low < high) both.push_back({low, high, {}, {}});
    a[i].high < b[k].high ? ++i : ++k;
  }
  return both;
}

/// Triangle on one level, with the box in which it may be touched.
struct Candidate {
  double along_low = 0, along_high = 0;
  double across_low = 0, across_high = 0;
  uint32_t triangle = 0;
  bool settled = false;  ///< true if only the shaft can touch the triangle
};

struct PushJob {
  const FiberFrame& frame;
  const Cutter& cutter;
  const FiberGrid& grid;
  std::span<const double> levels_mm;
  const std::vector<TriangleBox>& boxes;
  const CancelToken& cancel;
  std::vector<FiberIntervals>& result;  ///< result per level
};

/// Pushes the cutter along the fibers of one block, level by level.
class BlockPush {
 public:
  BlockPush(const PushJob& job, std::span<const uint32_t> triangles, EdgeMemory& memory)
      : job_(job), triangles_(triangles), memory_(memory) {}

  /// Returns false if cancelled.
  bool Run(int32_t first, int32_t last) {
    settled_.resize(static_cast<size_t>(last - first));
    for (size_t level = 0; level < job_.levels_mm.size(); ++level) {
      if (level > 0) KnowOfAll(job_.result[level - 1], first, last);
      Gather(job_.levels_mm[level]);
      for (int32_t fiber = first; fiber < last; ++fiber) {
        if (job_.cancel.Cancelled()) return false;
        Push(level, fiber, settled_[static_cast<size_t>(fiber - first)]);
      }
      std::erase_if(active_, [&](uint32_t t) { return IsSettled(t, job_.levels_mm[level]); });
    }
    return true;
  }

 private:
  bool IsSettled(uint32_t triangle, double z_mm) const {
    return job_.boxes[triangle].bottom - z_mm >= job_.cutter.full_height_mm();
  }

  /// Stores in `known_` the intervals that are gouged on all fibers of the block on the level
  /// above.
  void KnowOfAll(const FiberIntervals& above, int32_t first, int32_t last) {
    std::vector<Interval> all = above[static_cast<size_t>(first)];
    for (int32_t fiber = first + 1; fiber < last && !all.empty(); ++fiber)
      all = Intersection(all, above[static_cast<size_t>(fiber)]);
    known_.Clear();
    AddKnown(all, known_);
  }

  void Gather(double z_mm) {
    while (next_ < triangles_.size() && job_.boxes[triangles_[next_]].top - z_mm > kTouchMm)
      active_.push_back(triangles_[next_++]);
    candidates_.clear();
    const double radius = job_.cutter.radius_mm();
    std::erase_if(active_, [&](uint32_t t) {
      const TriangleBox& box = job_.boxes[t];
      // The shaft is the widest part of the cutter. If a known interval contains everything that
      // the shaft could gouge at this triangle, the triangle adds nothing on this and all lower
      // levels.
      if (known_.Covers(box.along_low - radius, box.along_high + radius)) return true;
      const double reach = job_.cutter.Width(box.top - z_mm);
      if (known_.Covers(box.along_low - reach, box.along_high + reach)) return false;
      candidates_.push_back({box.along_low - reach, box.along_high + reach, box.across_low - reach,
                             box.across_high + reach, t, IsSettled(t, z_mm)});
      return false;
    });
  }

  void Push(size_t level, int32_t index, IntervalSet& settled) {
    const Fiber fiber{job_.grid.At(index), job_.levels_mm[level]};
    memory_.NextFiber();
    gouged_ = settled;
    if (level > 0) AddKnown(job_.result[level - 1][index], gouged_);
    for (const Candidate& c : candidates_) {
      if (!(c.across_low < fiber.across_mm && fiber.across_mm < c.across_high)) continue;
      if (gouged_.Covers(c.along_low, c.along_high)) continue;
      const Interval found = PushOne(c.triangle, fiber);
      if (!(found.low < found.high)) continue;
      gouged_.Add(found);
      if (c.settled) settled.Add(found);
    }
    job_.result[level][index] = gouged_.items();
  }

  Interval PushOne(uint32_t triangle, const Fiber& fiber) {
    const auto& sides = job_.frame.edges().of_triangle[triangle];
    std::array<Reach, 3> reaches;
    for (int k = 0; k < 3; ++k) reaches[k] = memory_.Of(job_.frame, job_.cutter, sides[k], fiber);
    return job_.frame.Hull(job_.cutter, triangle, fiber, reaches);
  }

  static void AddKnown(const std::vector<Interval>& above, IntervalSet& set) {
    for (Interval known : above) {
      known.low += kKnownMarginMm;
      known.high -= kKnownMarginMm;
      if (known.low < known.high) set.Add(known);
    }
  }

  const PushJob& job_;
  std::span<const uint32_t> triangles_;
  EdgeMemory& memory_;
  size_t next_ = 0;
  std::vector<uint32_t> active_;
  std::vector<Candidate> candidates_;
  std::vector<IntervalSet> settled_;  ///< intervals of settled triangles, per fiber of the block
  IntervalSet known_;                 ///< intervals that are gouged on all fibers of the block
  IntervalSet gouged_;
};

}  // namespace

absl::StatusOr<std::vector<FiberIntervals>> PushFibers(const FiberFrame& frame,
                                                       const Cutter& cutter, const FiberGrid& grid,
                                                       std::span<const double> levels_mm,
                                                       int threads, const CancelToken& cancel) {
  std::vector<TriangleBox> boxes;
  boxes.reserve(frame.mesh().triangles.size());
  for (uint32_t t = 0; t < frame.mesh().triangles.size(); ++t) boxes.push_back(BoxOf(frame, t));
  const TriangleBlocks blocks(boxes, grid, cutter.radius_mm());
  std::vector<FiberIntervals> result(levels_mm.size(),
                                     FiberIntervals(static_cast<size_t>(grid.count)));
  const PushJob job{frame, cutter, grid, levels_mm, boxes, cancel, result};
  std::vector<EdgeMemory> memories(static_cast<size_t>(std::max(threads, 1)),
                                   EdgeMemory(frame.edges().ends.size()));
  std::atomic<bool> cancelled = false;
  ForEachIndex(threads, static_cast<size_t>(blocks.count()), [&](size_t block, int worker) {
    const int32_t first = static_cast<int32_t>(block) * kFibersOfBlock;
    BlockPush push(job, blocks.Of(block), memories[static_cast<size_t>(worker)]);
    if (!cancelled && !push.Run(first, std::min(first + kFibersOfBlock, grid.count)))
      cancelled = true;
  });
  if (cancelled) return cancel.Check();
  return result;
}

}  // namespace slicefarm::milling
