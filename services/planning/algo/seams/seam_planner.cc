#include "services/planning/algo/seams/seam_planner.h"

#include <algorithm>
#include <utility>

#include "common/model/options/planning_options.h"
#include "services/planning/algo/seams/seam_costs.h"
#include "services/planning/algo/seams/seam_lines.h"

namespace slicefarm::planning {
namespace {

/// Longest step that does not count as a jump.
constexpr double kJumpMm = 1;
/// Largest increase of the overhang when a seam moves, in heights of a layer.
constexpr float kMoreOverhang = 0.1F;

/// Returns the range within which a seam may move. Seams at corners are fixed, and no seam moves
/// into or out of a painted area.
SeamChoice ChoiceOf(const std::vector<SeamCandidate>& candidates, int32_t chosen) {
  const auto count = static_cast<int32_t>(candidates.size());
  const SeamCandidate& seam = candidates[static_cast<size_t>(chosen)];
  const auto end_towards = [&](int32_t neighbour) {
    const SeamCandidate& candidate = candidates[static_cast<size_t>((neighbour + count) % count)];
    const bool suits = !IsCorner(seam) && candidate.enforced == seam.enforced &&
                       candidate.blocked == seam.blocked &&
                       candidate.overhang <= seam.overhang + kMoreOverhang;
    return suits ? candidate.at : seam.at;
  };
  return {-1, seam.at, end_towards(chosen - 1), end_towards(chosen + 1)};
}

}  // namespace

bool SeamPlanner::IsPlanned(const ObjectSection& section) const {
  if (!section.stack.IsPart()) return false;
  const SeamPosition asked = options_.objects[static_cast<size_t>(section.stack.object)].seam;
  return asked != SeamPosition::kNearest || !MarkedIn(section, PartRole::kSeamEnforcer).empty() ||
         !MarkedIn(section, PartRole::kSeamBlocker).empty();
}

SeamPosition SeamPlanner::PositionOf(int32_t object) const {
  const SeamPosition asked = options_.objects[static_cast<size_t>(object)].seam;
  return asked == SeamPosition::kNearest ? SeamPosition::kAligned : asked;
}

void SeamPlanner::Look(const SlicedLayer& layer, LayerPlan& plan) {
  (void)plan;
  for (const ObjectSection& section : layer.sections) {
    if (!IsPlanned(section)) continue;
    ObjectSeams& seams = objects_[section.stack.object];
    seams.occupancy.Add(OutlineOf(section), section.z_nm);
    const auto first = static_cast<int32_t>(seams.rings.size());
    int32_t number = 0;
    for (RingCandidates& ring : seams.finder.Next(section)) {
      candidates_ += ring.candidates.size();
      seams.rings.push_back({.layer = layers_,
                             .number = {section.stack.object, section.layer, number++},
                             .z_nm = section.z_nm,
                             .parent = ring.below < 0 ? -1 : seams.first_below + ring.below,
                             .candidates = std::move(ring.candidates)});
    }
    seams.first_below = first;
  }
  ++layers_;
}

std::vector<SeamNode> SeamPlanner::NodesOf(ObjectSeams& seams, SeamPosition position) {
  std::vector<SeamNode> nodes;
  nodes.reserve(seams.rings.size());
  for (const Ring& ring : seams.rings) {
    SeamNode& node = nodes.emplace_back();
    node.parent = ring.parent;
    std::vector<double> seen;
    for (const SeamCandidate& candidate : ring.candidates) {
      node.candidates.push_back(candidate.at);
      node.away_mm.push_back(candidate.away_mm);
      seen.push_back(seams.occupancy.Visibility(candidate.at, ring.z_nm, candidate.outward));
    }
    node.costs = SeamCosts(ring.candidates, seen, position, ring.number);
  }
  return nodes;
}

void SeamPlanner::Choose(ObjectSeams& seams, SeamPosition position) {
  const StepCost step = StepCostOf(position);
  const std::vector<int32_t> chosen = CheapestSeams(NodesOf(seams, position), step);
  std::vector<SeamChoice> choices;
  choices.reserve(seams.rings.size());
  for (size_t i = 0; i < seams.rings.size(); ++i) {
    Ring& ring = seams.rings[i];
    ring.seam = ring.candidates[static_cast<size_t>(chosen[i])];
    SeamChoice& choice = choices.emplace_back(ChoiceOf(ring.candidates, chosen[i]));
    if (ring.parent < 0) continue;
    const Ring& below = seams.rings[static_cast<size_t>(ring.parent)];
    if (step.Reaches(below.seam.at, ring.seam.at, ring.seam.away_mm)) choice.parent = ring.parent;
  }
  const std::vector<Point> smooth = SmoothSeams(choices);
  for (size_t i = 0; i < smooth.size(); ++i) seams.rings[i].seam.at = smooth[i];
}

void SeamPlanner::Count(const std::vector<Ring>& rings, const Ring& ring) {
  ++quality_.loops;
  if (Overhangs(ring.seam)) ++quality_.overhanging;
  if (std::ranges::any_of(ring.candidates, IsCorner)) {
    ++quality_.with_corner;
    if (IsCorner(ring.seam)) ++quality_.on_corner;
  }
  if (ring.parent < 0) return;
  ++quality_.followers;
  const Ring& below = rings[static_cast<size_t>(ring.parent)];
  const double step_mm = ToMm(Distance(ring.seam.at, below.seam.at));
  if (step_mm > kJumpMm) {
    ++quality_.jumps;
  } else {
    quality_.steps_mm += step_mm;
  }
}

void SeamPlanner::FinishBelow(int32_t end, int32_t object, ObjectSeams& seams, OpenLayers& layers) {
  seams.occupancy.Build();
  Choose(seams, PositionOf(object));
  size_t i = seams.finished;
  for (; i < seams.rings.size() && seams.rings[i].layer < end; ++i) {
    const Ring& ring = seams.rings[i];
    PlanOf(object, layers.At(ring.layer)).seams.push_back(ring.seam.at);
    Count(seams.rings, ring);
    candidates_ -= ring.candidates.size();
  }
  Forget(i, seams);
}

/// Removes the first `rings` rings except the highest layer among them. The rings of this layer
/// keep their seam as the only possible point, because the layers above follow it.
void SeamPlanner::Forget(size_t rings, ObjectSeams& seams) {
  if (rings == 0) return;
  size_t first = rings;
  while (first > 0 && seams.rings[first - 1].layer == seams.rings[rings - 1].layer) --first;
  for (size_t i = first; i < rings; ++i) {
    Ring& ring = seams.rings[i];
    ring.candidates = {ring.seam};
    ring.parent = -1;
  }
  seams.rings.erase(seams.rings.begin(), seams.rings.begin() + static_cast<ptrdiff_t>(first));
  seams.finished = rings - first;
  seams.first_below -= static_cast<int32_t>(first);
  for (size_t i = seams.finished; i < seams.rings.size(); ++i)
    if (seams.rings[i].parent >= 0) seams.rings[i].parent -= static_cast<int32_t>(first);
}

int32_t SeamPlanner::Revise(OpenLayers& layers) {
  int32_t finished = layers.end();
  const bool too_many = candidates_ > max_candidates_;
  for (auto& [object, seams] : objects_) {
    if (seams.finished == seams.rings.size()) continue;
    const int32_t first = seams.rings[seams.finished].layer;
    if (too_many) {
      const int32_t middle = seams.rings[(seams.finished + seams.rings.size()) / 2].layer;
      FinishBelow(std::max(middle, first + 1), object, seams, layers);
    }
    if (seams.finished < seams.rings.size())
      finished = std::min(finished, seams.rings[seams.finished].layer);
  }
  return finished;
}

absl::Status SeamPlanner::Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) {
  for (auto& [object, seams] : objects_) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    FinishBelow(layers.end(), object, seams, layers);
  }
  plan.seams = quality_;
  return absl::OkStatus();
}

}  // namespace slicefarm::planning
