#include "services/planning/algo/supports/generator/support_planner.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/base/parallel.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_rings.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/branch_drawing.h"
#include "services/planning/algo/supports/generator/branches.h"
#include "services/planning/algo/supports/generator/clearance.h"
#include "services/planning/algo/supports/generator/columns.h"
#include "services/planning/algo/supports/generator/first_layer.h"
#include "services/planning/algo/supports/generator/interfaces.h"
#include "services/planning/algo/supports/generator/kept_rings.h"
#include "services/planning/algo/supports/generator/overhangs.h"
#include "services/planning/algo/supports/generator/reach_field.h"
#include "services/planning/algo/supports/generator/small_overhangs.h"
#include "services/planning/algo/supports/generator/standing.h"
#include "services/planning/algo/supports/generator/support_heights.h"

namespace slicefarm::planning {
namespace {

/// Sideways reach of branches around the sheets that they support.
constexpr Coord kAroundNm = 12'000'000;
/// Distance from support or part within which an overhang counts as supported, with branches and
/// with columns.
constexpr Coord kTreeSupportMarginNm = 1'000'000;
constexpr Coord kSupportMarginNm = 500'000;
/// Smallest area of an unsupported overhang that is reported.
constexpr double kReportedNm2 = 0.05e12;

SupportFinding FindingAt(SupportFinding::Kind kind, const SupportProblem& problem, size_t layer,
                         const PolygonWithHoles& island) {
  SupportFinding finding;
  finding.kind = kind;
  finding.layer = static_cast<int32_t>(layer);
  finding.bottom_nm = problem.part[layer].bottom_nm();
  finding.place = Centroid(island.outer);
  finding.area_mm2 = Area(island) / (kNmPerMm * static_cast<double>(kNmPerMm));
  return finding;
}

/// One run of PlanSupports.
class Planner {
 public:
  Planner(const SupportProblem& problem, const SupportOptions& options, int threads,
          const CancelToken& cancel)
      : problem_(problem),
        options_(options),
        standing_(options),
        threads_(threads),
        cancel_(cancel) {}

  absl::StatusOr<SupportPlan> Run() {
    FindOverhangs();
    if (cancel_.Cancelled()) return cancel_.Check();
    heights_ = HeightsFor(problem_, overhangs_, options_);
    if (!heights_.layers.empty()) {
      const Clearance clearance(problem_, options_, heights_.layers.back().top_nm, threads_,
                                cancel_);
      if (cancel_.Cancelled()) return cancel_.Check();
      FindContacts(clearance);
      const absl::Status made =
          options_.style == SupportStyle::kTree ? Grow(clearance) : Raise(clearance);
      if (!made.ok()) return made;
      KeepStanding(problem_, standing_, threads_, cancel_, plan_.layers);
    }
    plan_.findings = Findings();
    FindSupported();
    if (cancel_.Cancelled()) return cancel_.Check();
    return std::move(plan_);
  }

 private:
  void FindOverhangs() {
    overhangs_.resize(problem_.part.size());
    ForEachIndex(threads_, overhangs_.size(), [&](size_t i, int) {
      if (!cancel_.Cancelled()) overhangs_[i] = OverhangOf(problem_, i, options_);
    });
    if (options_.ignore_small && !cancel_.Cancelled())
      RemoveSmallOverhangs(problem_, options_, overhangs_);
  }

  void FindContacts(const Clearance& clearance) {
    const size_t count = heights_.layers.size();
    std::vector<std::vector<size_t>> on(count);
    for (size_t i = 0; i < heights_.under.size(); ++i)
      if (heights_.under[i] >= 0) on[static_cast<size_t>(heights_.under[i])].push_back(i);
    contacts_.resize(count);
    enforced_.resize(count);
    ForEachIndex(threads_, count, [&](size_t i, int) {
      if (cancel_.Cancelled()) return;
      MultiPolygon contact, enforced;
      for (const size_t part_layer : on[i]) {
        contact = Union(contact, overhangs_[part_layer].contact);
        if (options_.bed_only) enforced = Union(enforced, EnforcedContact(part_layer));
      }
      if (options_.expansion_nm != 0 && options_.style != SupportStyle::kTree && !contact.empty())
        contact = FastOffset(contact, options_.expansion_nm);
      const SupportHeight& height = heights_.layers[i];
      contacts_[i] = clearance.Free(contact, height.bottom_nm, height.top_nm);
      if (!enforced.empty()) enforced_[i] = Intersection(contacts_[i], enforced);
    });
  }

  /// Returns the part of a contact under enforced areas of the underside.
  MultiPolygon EnforcedContact(size_t part_layer) const {
    const MultiPolygon* enforcers = problem_.part[part_layer].enforcers;
    if (enforcers == nullptr || overhangs_[part_layer].contact.empty()) return {};
    return Intersection(overhangs_[part_layer].contact, FastOffset(*enforcers, options_.width_nm));
  }

  absl::Status Raise(const Clearance& clearance) {
    auto columns = Columns(problem_, heights_, contacts_, clearance, options_, threads_, cancel_);
    if (!columns.ok()) return columns.status();
    if (absl::Status added = AddEnforced(clearance, *columns); !added.ok()) return added;
    DropUseless(contacts_, 2 * (options_.spacing_nm + options_.width_nm), *columns);
    plan_.layers =
        ColumnLayers(problem_, heights_, *columns, contacts_, standing_, threads_, cancel_);
    return absl::OkStatus();
  }

  /// Adds columns under enforced areas. With bed_only, these columns may nevertheless end on the
  /// part, because the user has requested support there.
  absl::Status AddEnforced(const Clearance& clearance, std::vector<MultiPolygon>& columns) {
    const auto none = [](const MultiPolygon& contact) { return contact.empty(); };
    if (std::ranges::all_of(enforced_, none)) return absl::OkStatus();
    standing_.bed_only = false;
    auto own = Columns(problem_, heights_, enforced_, clearance, standing_, threads_, cancel_);
    if (!own.ok()) return own.status();
    ForEachIndex(threads_, columns.size(), [&](size_t i, int) {
      if (!cancel_.Cancelled() && !(*own)[i].empty()) columns[i] = Union(columns[i], (*own)[i]);
    });
    return absl::OkStatus();
  }

  absl::Status Grow(const Clearance& clearance) {
    const std::vector<MultiPolygon> sheets =
        Sheets(heights_, contacts_, clearance, options_, threads_, cancel_);
    Box box;
    for (const MultiPolygon& sheet : sheets) box.Add(Bounds(sheet));
    if (box.Empty()) return absl::OkStatus();
    auto field =
        ReachField::Make(problem_, heights_, box.Grown(kAroundNm), options_, threads_, cancel_);
    if (!field.ok()) return field.status();
    auto branches =
        GrowBranches(*field, heights_, Undersides(field->grid(), sheets), options_, cancel_);
    if (!branches.ok()) return branches.status();
    const auto sections =
        DrawBranches(*branches, *field, heights_, clearance, options_, threads_, cancel_);
    if (cancel_.Cancelled()) return cancel_.Check();
    plan_.layers = BranchLayers(problem_, heights_, sections, sheets,
                                Plinths(heights_, contacts_, clearance, threads_, cancel_),
                                options_, threads_, cancel_);
    if (!plan_.layers.empty() && plan_.layers.front().first)
      GrowFirstLayer(problem_.first_layer_expansion_nm, options_.width_nm, clearance,
                     plan_.layers.front());
    KeepRings(problem_, options_, threads_, cancel_, plan_.layers);
    return absl::OkStatus();
  }

  /// Returns the pixels of each sheet that have no sheet below them.
  std::vector<std::vector<int32_t>> Undersides(const PixelGrid& grid,
                                               const std::vector<MultiPolygon>& sheets) const {
    std::vector<std::vector<int32_t>> undersides(sheets.size());
    ForEachIndex(threads_, sheets.size(), [&](size_t i, int) {
      if (i == 0 || sheets[i].empty() || cancel_.Cancelled()) return;
      Bitmap here(grid), below(grid);
      here.Fill(sheets[i]);
      below.Fill(sheets[i - 1]);
      const uint8_t *h = here.Row(0), *b = below.Row(0);
      for (size_t k = 0; k < grid.size(); ++k)
        if (h[k] && !b[k]) undersides[i].push_back(static_cast<int32_t>(k));
    });
    return undersides;
  }

  /// Finds the areas of contacts with a support below. The support's top may be up to one layer
  /// height below the gap, because strands sag by this distance.
  void FindSupported() {
    plan_.above_supports.resize(overhangs_.size());
    ForEachIndex(threads_, overhangs_.size(), [&](size_t i, int) {
      const MultiPolygon& contact = overhangs_[i].contact;
      if (contact.empty() || cancel_.Cancelled()) return;
      const Coord bottom = problem_.part[i].bottom_nm();
      const Coord lowest = bottom - options_.top_gap_nm - options_.layer_height_nm;
      const MultiPolygon wide = FastOffset(contact, options_.width_nm);
      const Box box = Bounds(wide);
      std::vector<Polygon> rings;
      auto layer = std::partition_point(plan_.layers.begin(), plan_.layers.end(),
                                        [&](const SupportLayer& l) { return l.top_nm < lowest; });
      for (; layer != plan_.layers.end() && layer->top_nm <= bottom; ++layer)
        for (const SupportRegion& region : layer->regions)
          AppendRingsNear(region.outlines, box, rings);
      if (!rings.empty())
        plan_.above_supports[i] = Intersection(wide, Union(rings, FillRule::kNonZero));
    });
  }

  std::vector<SupportFinding> Findings() const {
    std::vector<SupportFinding> findings = IslandsInAir(problem_, threads_, cancel_);
    std::vector<std::vector<SupportFinding>> by_layer(overhangs_.size());
    ForEachIndex(threads_, overhangs_.size(), [&](size_t i, int) {
      if (overhangs_[i].steep.empty() || cancel_.Cancelled()) return;
      for (const PolygonWithHoles& island : Unsupported(i))
        if (Area(island) >= kReportedNm2)
          by_layer[i].push_back(FindingAt(SupportFinding::Kind::kUnsupported, problem_, i, island));
    });
    for (SupportFinding& finding : findings) {
      const auto& unsupported = by_layer[static_cast<size_t>(finding.layer)];
      finding.above_supports =
          std::none_of(unsupported.begin(), unsupported.end(), [&](const auto& n) {
            return Distance(n.place, finding.place) * Distance(n.place, finding.place) <
                   finding.area_mm2 * 1e12;
          });
    }
    for (auto& layer : by_layer)
      std::move(layer.begin(), layer.end(), std::back_inserter(findings));
    std::stable_sort(findings.begin(), findings.end(), [](const auto& a, const auto& b) {
      return std::pair(a.layer, a.place) < std::pair(b.layer, b.place);
    });
    return findings;
  }

  /// Returns the areas of an overhang that neither the part's layer below nor a support right under
  /// the overhang is near enough to support. The result is empty for overhangs too low for a
  /// support, because the bed supports them.
  MultiPolygon Unsupported(size_t part_layer) const {
    const MultiPolygon& steep = overhangs_[part_layer].steep;
    const int32_t under = heights_.under[part_layer];
    if (under < 0) return {};
    const Coord reach =
        options_.style == SupportStyle::kTree ? kTreeSupportMarginNm : kSupportMarginNm;
    const Coord top = heights_.layers[static_cast<size_t>(under)].top_nm;
    // Tests supports first: their outlines are small, and usually enough.
    MultiPolygon left = steep;
    const auto take = [&](const MultiPolygon& supporter) {
      if (left.empty()) return;
      std::vector<Polygon> near;
      AppendRingsNear(supporter, Bounds(left).Grown(2 * reach), near);
      left = WithoutRings(left, Rings(FastOffset(Union(near, FillRule::kNonZero), reach)));
    };
    const auto layer = std::partition_point(plan_.layers.begin(), plan_.layers.end(),
                                            [&](const SupportLayer& l) { return l.top_nm < top; });
    if (layer != plan_.layers.end() && layer->top_nm == top)
      for (const SupportRegion& region : layer->regions) take(region.outlines);
    take(*problem_.part[part_layer - 1].outlines);
    return left;
  }

  const SupportProblem& problem_;
  const SupportOptions& options_;
  SupportOptions standing_;  ///< options without bed_only if enforced columns may end on the part
  const int threads_;
  const CancelToken& cancel_;
  std::vector<Overhang> overhangs_;
  SupportHeights heights_;
  Contacts contacts_;
  Contacts enforced_;  ///< part of `contacts_` under enforced areas; only with bed_only
  SupportPlan plan_;
};

}  // namespace

absl::StatusOr<SupportPlan> PlanSupports(const SupportProblem& problem,
                                         const SupportOptions& options, int threads,
                                         const CancelToken& cancel) {
  return Planner(problem, options, threads, cancel).Run();
}

std::vector<SupportFinding> IslandsInAir(const SupportProblem& problem, int threads,
                                         const CancelToken& cancel) {
  std::vector<std::vector<SupportFinding>> by_layer(problem.part.size());
  ForEachIndex(threads, by_layer.size(), [&](size_t i, int) {
    if (cancel.Cancelled()) return;
    for (const PolygonWithHoles& island : IslandsInAirOf(problem, i))
      by_layer[i].push_back(FindingAt(SupportFinding::Kind::kStartsInAir, problem, i, island));
  });
  std::vector<SupportFinding> findings;
  for (auto& layer : by_layer) std::move(layer.begin(), layer.end(), std::back_inserter(findings));
  return findings;
}

}  // namespace slicefarm::planning
