#include "services/planning/algo/travel/travel_planner.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "common/geometry/measure.h"

namespace slicefarm::planning {
namespace {

/// Largest number of islands that are visited by nearest neighbour. More islands are visited in
/// their given order.
constexpr size_t kMaxVisited = 2000;
/// Point from which objects are entered first: far to the front left, where the nozzle is at first.
constexpr Point kFrontLeft{-1'000 * kNmPerMm, -1'000 * kNmPerMm};

double DistanceToBox(Point p, const Box& box) {
  const Point nearest{std::clamp(p.x, box.min.x, box.max.x), std::clamp(p.y, box.min.y, box.max.y)};
  return Distance(p, nearest);
}

Point Nearest(const Polygon& ring, Point to) {
  return *std::min_element(ring.begin(), ring.end(), [to](Point a, Point b) {
    return SquaredNorm(a - to) < SquaredNorm(b - to);
  });
}

/// Exit point, and the rings of its island.
struct LikelyExit {
  Point at;
  RingRange rings;
};

struct Island {
  const Polygon* ring = nullptr;
  Box box;
  RingRange rings;
};

std::vector<Island> IslandsOf(const MultiPolygon& outlines) {
  std::vector<Island> islands;
  int32_t rings = 0;
  for (const PolygonWithHoles& island : outlines) {
    const int32_t first = rings;
    rings += 1 + static_cast<int32_t>(island.holes.size());
    islands.push_back({&island.outer, Bounds(island.outer), {first, rings}});
  }
  return islands;
}

/// Estimates the exit of a section that is entered at `entry`. Islands are visited by nearest
/// neighbour, and each is left at the point where it was entered. (An estimate that fill ends at
/// the far side of an island gives up to a quarter more travel.)
LikelyExit ExitOf(const MultiPolygon& outlines, Point entry) {
  std::vector<Island> left = IslandsOf(outlines);
  if (left.empty()) return {entry, {}};
  if (left.size() > kMaxVisited) return {left.back().ring->front(), left.back().rings};
  LikelyExit exit{entry, {}};
  Point& at = exit.at;
  while (!left.empty()) {
    // The inner one of nested islands is first.
    const auto next = std::ranges::min_element(left, {}, [&](const Island& island) {
      return std::pair(DistanceToBox(at, island.box), island.box.max.x - island.box.min.x);
    });
    at = Nearest(*next->ring, at);
    exit.rings = next->rings;
    left.erase(next);
  }
  return exit;
}

/// Largest distance between the seam of a wall and a seam of the layer below, for which the wall
/// counts as a continuation of the wall below.
constexpr double kSeamStepNm = 0.3 * kNmPerMm;

/// Returns the seam nearest to the section's entry, among the seams that continue one of the seams
/// in `below`; nullopt if there is none.
std::optional<Point> SeamToMeetAt(const SectionPlan& section, std::span<const Point> below) {
  std::optional<Point> nearest;
  for (const Point seam : section.seams) {
    const auto goes_on = [&](Point from) { return Distance(from, seam) <= kSeamStepNm; };
    if (nearest && Distance(seam, section.entry) >= Distance(*nearest, section.entry)) continue;
    if (std::ranges::any_of(below, goes_on)) nearest = seam;
  }
  return nearest;
}

/// Returns the seams of a section's rings, or nothing if they are not planned.
std::span<const Point> SeamsOf(const SectionPlan& section, RingRange rings) {
  const auto last = static_cast<size_t>(rings.last);
  if (last > section.seams.size()) return {};
  const auto first = static_cast<size_t>(rings.first);
  return std::span(section.seams).subspan(first, last - first);
}

SectionPlan* FindPlanOf(int32_t stack, LayerPlan& plan) {
  const auto found = std::ranges::find(plan.sections, stack, &SectionPlan::stack);
  return found == plan.sections.end() ? nullptr : &*found;
}

bool Has(const std::vector<int32_t>& objects, int32_t object) {
  return std::ranges::binary_search(objects, object);
}

}  // namespace

void TravelPlanner::Look(const SlicedLayer& layer, LayerPlan& plan) {
  std::vector<int32_t> objects;
  const bool is_single = copies_.size() == 1;
  if (is_single) {
    last_rings_.emplace_back();
    begins_with_support_.push_back(
        std::ranges::any_of(layer.sections, [](const ObjectSection& section) {
          return section.stack.kind == StackKind::kSupport && !section.regions.empty();
        }));
  }
  for (const ObjectSection& section : layer.sections) {
    if (section.stack.object == kPlateObject) continue;
    const auto [left_at, is_new] = left_at_.try_emplace(section.stack.object, kFrontLeft);
    PlanOf(section.stack.id, plan).entry = left_at->second;
    if (!section.stack.IsPart()) continue;  // the path through a support ends at the part
    const LikelyExit exit = ExitOf(OutlineOf(section), left_at->second);
    left_at->second = exit.at;
    if (is_single && section.stack.object == copies_.front().object)
      last_rings_.back() = exit.rings;
    if (!section.regions.empty()) objects.push_back(section.stack.object);
  }
  plan.entry = plate_left_at_;
  if (objects.empty() || copies_.empty()) return;
  const int32_t last = LastCopy({objects, NearestCopy(objects)});
  if (last < 0) return;
  const PlacedCopy& copy = copies_[static_cast<size_t>(last)];
  plate_left_at_ = copy.shift + left_at_[copy.object];
}

absl::Status TravelPlanner::Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) {
  (void)cancel, (void)plan;
  if (copies_.size() != 1) return absl::OkStatus();
  const PlacedCopy& copy = copies_.front();
  for (int32_t i = layers.first() + 1; i < layers.end(); ++i) {
    LayerPlan& below = layers.At(i - 1);
    LayerPlan& above = layers.At(i);
    SectionPlan* const left = FindPlanOf(copy.object, below);
    const SectionPlan* const entered = FindPlanOf(copy.object, above);
    if (left == nullptr || entered == nullptr) continue;  // one layer has only supports
    if (left->spiral || entered->spiral) continue;        // spiral turns already join
    const RingRange rings = last_rings_[static_cast<size_t>(i - 1)];
    const auto meeting = SeamToMeetAt(*entered, SeamsOf(*left, rings));
    if (!meeting || begins_with_support_[static_cast<size_t>(i)]) continue;
    above.entry = copy.shift + *meeting;
    left->exit = *meeting;
    below.ends_ready = above.begins_ready = true;
  }
  return absl::OkStatus();
}

int32_t TravelPlanner::NearestCopy(const std::vector<int32_t>& objects) const {
  int32_t nearest = -1;
  for (size_t i = 0; i < copies_.size(); ++i) {
    if (!Has(objects, copies_[i].object)) continue;
    if (nearest < 0 || Distance(copies_[i].shift, plate_left_at_) <
                           Distance(copies_[static_cast<size_t>(nearest)].shift, plate_left_at_))
      nearest = static_cast<int32_t>(i);
  }
  return nearest;
}

int32_t TravelPlanner::LastCopy(const Beginning& beginning) {
  if (beginning.second < 0) return -1;
  const auto [known, is_new] = last_copies_.try_emplace(beginning, beginning.second);
  if (!is_new) return known->second;
  std::vector<int32_t> left;
  for (size_t i = 0; i < copies_.size(); ++i)
    if (Has(beginning.first, copies_[i].object)) left.push_back(static_cast<int32_t>(i));
  int32_t at = beginning.second;
  const auto away = [&](int32_t copy) {
    return Distance(copies_[static_cast<size_t>(copy)].shift,
                    copies_[static_cast<size_t>(at)].shift);
  };
  for (std::erase(left, at); !left.empty(); std::erase(left, at))
    at = *std::ranges::min_element(left, {}, away);
  known->second = at;
  return at;
}

}  // namespace slicefarm::planning
