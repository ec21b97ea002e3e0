#include "services/slicing/algo/local_slicing_stage.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/parallel.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_holes.h"
#include "common/geometry/moved.h"
#include "common/model/limits.h"
#include "common/stage/job_memory.h"
#include "common/stage/print_layers.h"
#include "services/slicing/algo/counterbores/bridged_counterbores.h"
#include "services/slicing/algo/holes/polyholes.h"
#include "services/slicing/algo/holes/printable_overhangs.h"
#include "services/slicing/algo/placement/arranging/footprint.h"
#include "services/slicing/algo/placement/arranging/overlaps.h"
#include "services/slicing/algo/placement/orientation/orientation_advice.h"
#include "services/slicing/algo/placement/prepared_object.h"
#include "services/slicing/algo/section/adaptive_heights.h"
#include "services/slicing/algo/section/largest_contour.h"
#include "services/slicing/algo/section/layer_heights.h"
#include "services/slicing/algo/section/open_loops.h"
#include "services/slicing/algo/section/regions.h"
#include "services/slicing/algo/section/seam_area.h"
#include "services/slicing/algo/section/section_regions.h"
#include "services/slicing/algo/section/surface_facets.h"
#include "services/slicing/algo/section/surface_slabs.h"
#include "services/slicing/algo/section/sweep.h"
#include "services/slicing/algo/thumbnail/thumbnail.h"

namespace slicefarm::slicing {
namespace {

/// Sweep of one part, and the numbers of gaps in its sections.
struct SweptPart {
  const PreparedPart* part = nullptr;
  Sweep sweep;
  std::vector<GapCounts> gaps;  ///< numbers of gaps, indexed by the object's layers
  /// Slabs of a surface with seam or support marks, one for each layer of the object.
  std::optional<SurfaceSlabs> slabs = {};
};

/// Object that is being cut into sections.
struct SweptObject {
  std::vector<LayerPlane> planes;
  std::vector<SweptPart> parts;
  std::vector<int64_t> facet_counts = {};  ///< sizes of the elements of `surface`
  /// Facets of the upper side near each layer; empty without Z contouring.
  std::vector<std::vector<SurfaceFacet>> surface = {};
};

/// Bytes for a triangle, its neighbours and half a vertex.
constexpr int64_t kMemoryPerTriangle = 64;
/// Bytes for a point in a section and the index entry that finds it.
constexpr int64_t kMemoryPerPoint = 24;
/// Bytes for a facet, in the job and in the range that is being printed.
constexpr int64_t kMemoryPerFacet = 2 * sizeof(SurfaceFacet);

/// One call of the stage.
class SlicingRun {
 public:
  SlicingRun(const StageCall& call, const MeshSource& source, const SlicingOptions& options)
      : call_(call), source_(source), options_(options) {}

  absl::StatusOr<SlicedJob> Run(SliceInput input) {
    advise_orientations_ = input.advise_orientations;
    auto objects = PrepareObjects(std::move(input), source_, options_, call_.cancel);
    if (!objects.ok()) return objects.status();
    objects_ = *std::move(objects);
    absl::Status held =
        HoldMemory(call_, JobMemory::Kind::kMeshes, kMemoryPerTriangle * Triangles());
    if (!held.ok()) return held;
    for (auto step :
         {&SlicingRun::PlanLayers, &SlicingRun::CheckPointsPerLayer, &SlicingRun::Draw,
          &SlicingRun::CutLayers, &SlicingRun::CountOverlaps, &SlicingRun::AdviseOrientations})
      if (absl::Status status = (this->*step)(); !status.ok()) return status;
    return Result();
  }

 private:
  absl::Status PlanLayers() {
    for (size_t i = 0; i < objects_.size(); ++i) {
      const PreparedObject& object = objects_[i];
      const ObjectSlicingOptions& slicing = options_.objects[i];
      auto planes = PlanesOf(object, slicing);
      if (!planes.ok()) return planes.status();
      if (slicing.contour.on) LowerCuts(slicing.contour.least_nm, *planes);
      absl::StatusOr<SweptObject> swept = Swept(object, slicing, *std::move(planes));
      if (!swept.ok()) return swept.status();
      swept_.push_back(*std::move(swept));
    }
    // The memory is reserved before the parts are cut and facets are stored, because the numbers of
    // points and facets are known already.
    absl::Status held = HoldMemory(call_, JobMemory::Kind::kOutlines,
                                   kMemoryPerPoint * points_ + kMemoryPerFacet * facets_);
    if (!held.ok()) return held;
    StoreSurfaces();
    LayOutSections();
    return absl::OkStatus();
  }

  absl::StatusOr<std::vector<LayerPlane>> PlanesOf(const PreparedObject& object,
                                                   const ObjectSlicingOptions& slicing) const {
    const Coord first_nm =
        slicing.on_bed ? options_.first_layer_height_nm : slicing.layer_height_nm;
    const AdaptiveHeights& adaptive = slicing.adaptive;
    // An object lower than half the first layer has no layers. Its error is reported later.
    if (!adaptive.on || !slicing.height_profile.empty() || first_nm / 2 >= object.top_nm) {
      auto planes = LayerPlanes(object.top_nm, {first_nm, slicing.layer_height_nm, object.ranges,
                                                slicing.height_profile, adaptive.min_nm / 2});
      if (planes.ok() && slicing.precise_top)
        MeetTop(object.top_nm, {adaptive.min_nm, adaptive.max_nm}, *planes);
      return planes;
    }
    HeightProblem problem{
        .solids = {}, .top_nm = object.top_nm, .first_nm = first_nm, .ranges = object.ranges};
    for (const PreparedPart& part : object.parts)
      if (part.input.role == PartRole::kSolid) problem.solids.push_back(&part.connected.mesh);
    return PlanesBelow(AdaptiveTops(problem, adaptive));
  }

  int64_t Triangles() const {
    int64_t triangles = 0;
    for (const PreparedObject& object : objects_)
      for (const PreparedPart& part : object.parts)
        triangles += std::ssize(part.connected.mesh.triangles);
    return triangles;
  }

  absl::StatusOr<SweptObject> Swept(const PreparedObject& object,
                                    const ObjectSlicingOptions& slicing,
                                    std::vector<LayerPlane> planes) {
    SweptObject swept{std::move(planes), {}};
    std::vector<Coord> heights;
    for (const LayerPlane& plane : swept.planes) heights.push_back(plane.z_nm);
    for (const PreparedPart& part : object.parts) {
      absl::StatusOr<Sweep> sweep = Sweep::Prepare(part.connected, heights, points_);
      if (!sweep.ok()) return sweep.status();
      points_ += sweep->segments();
      swept.parts.push_back({&part, *std::move(sweep), std::vector<GapCounts>(heights.size())});
      if (part.IsMarkedSurface()) swept.parts.back().slabs = SlabsOf(part, swept.planes);
    }
    if (!slicing.contour.on) return swept;
    swept.facet_counts = CountFacets(SolidsOf(object), swept.planes);
    if (absl::Status status = AddFacets(swept.facet_counts); !status.ok()) return status;
    return swept;
  }

  /// Adds facets of an object's layers to the job's.
  absl::Status AddFacets(const std::vector<int64_t>& counts) {
    for (const int64_t count : counts) {
      facets_ += count;
      if (count > limits::kMaxFacetsPerLayer)
        return LimitError(Reason::kMeshTooLarge, "facets of the upper side in a layer",
                          limits::kMaxFacetsPerLayer, count);
    }
    if (facets_ > limits::kMaxFacetsPerJob)
      return LimitError(Reason::kMeshTooLarge, "facets of the upper sides in all layers",
                        limits::kMaxFacetsPerJob, facets_);
    return absl::OkStatus();
  }

  void StoreSurfaces() {
    for (size_t i = 0; i < swept_.size(); ++i)
      if (options_.objects[i].contour.on)
        swept_[i].surface =
            FacetsOfLayers(SolidsOf(objects_[i]), swept_[i].planes, swept_[i].facet_counts);
  }

  static std::vector<const IndexedMesh*> SolidsOf(const PreparedObject& object) {
    std::vector<const IndexedMesh*> solids;
    for (const PreparedPart& part : object.parts)
      if (part.input.role == PartRole::kSolid) solids.push_back(&part.connected.mesh);
    return solids;
  }

  /// Returns the slab of heights for each layer. Seam marks: the slab is the layer itself, because
  /// a level face counts in the layers of which it is the bottom or the top. Support marks: the
  /// slab is between the cut of the layer below and the layer's own cut, where a layer's overhang
  /// is.
  static SurfaceSlabs SlabsOf(const PreparedPart& part, const std::vector<LayerPlane>& planes) {
    std::vector<Slab> slabs;
    Coord below = std::numeric_limits<int32_t>::min();
    for (const LayerPlane& plane : planes) {
      const Coord top = plane.frame.print_z_nm;
      slabs.push_back(part.IsForSeams() ? Slab{top - plane.frame.height_nm, top}
                                        : Slab{below, plane.z_nm});
      below = plane.z_nm;
    }
    return SurfaceSlabs(
        part.connected.mesh, std::move(slabs),
        part.IsForSeams() ? SurfaceSlabs::Faces::kLevelAlone : SurfaceSlabs::Faces::kAll);
  }

  /// Groups the sections of all objects by their height above the objects' own bottoms.
  void LayOutSections() {
    std::map<Coord, std::vector<ObjectSection>> by_top;
    for (size_t object = 0; object < swept_.size(); ++object) {
      if (objects_[object].shifts.empty()) continue;  // none of its copies is on the bed
      const std::vector<LayerPlane>& planes = swept_[object].planes;
      for (const LayerPlane& plane : planes) {
        ObjectSection section;
        section.stack = static_cast<int32_t>(object);
        section.layer = plane.frame.index;
        section.layer_count = static_cast<int32_t>(planes.size());
        section.height_nm = plane.frame.height_nm;
        section.z_nm = plane.frame.print_z_nm;
        const int32_t hollow_from = options_.objects[object].hollow_from;
        section.hollow = hollow_from > 0 && section.layer >= hollow_from;
        by_top[plane.frame.print_z_nm].push_back(std::move(section));
      }
    }
    Coord below = 0;
    for (auto& [top, sections] : by_top) {
      const auto index = static_cast<int32_t>(job_.layers.size());
      job_.layers.push_back({{index, top, top - below}, std::move(sections)});
      below = top;
    }
  }

  absl::Status CheckPointsPerLayer() {
    if (std::ssize(job_.layers) > limits::kMaxLayers)
      return LimitError(Reason::kMeshTooLarge, "layers of all objects", limits::kMaxLayers,
                        std::ssize(job_.layers));
    for (const SlicedLayer& layer : job_.layers) {
      int64_t points = 0;
      for (const ObjectSection& section : layer.sections)
        for (const SweptPart& part : swept_[static_cast<size_t>(section.stack.object)].parts)
          points += part.sweep.segments(static_cast<size_t>(section.layer));
      if (points > limits::kMaxPointsPerLayer)
        return LimitError(Reason::kMeshTooLarge, "points in a layer", limits::kMaxPointsPerLayer,
                          points);
    }
    return absl::OkStatus();
  }

  absl::Status Draw() {
    std::vector<SceneMesh> scene;
    int32_t copies = 0;
    for (const PreparedObject& object : objects_) {
      for (const PreparedPart& part : object.parts) {
        if (part.input.role != PartRole::kSolid) continue;
        const bool solid = part.connected.closed && part.report.volume_mm3 > 0;
        scene.push_back({&part.connected.mesh, object.shifts, solid, copies});
      }
      copies += static_cast<int32_t>(object.shifts.size());
    }
    for (const ThumbnailSize& size : options_.thumbnails) {
      absl::StatusOr<Thumbnail> thumbnail =
          RenderThumbnail(scene, options_.bed, size, call_.cancel);
      if (!thumbnail.ok()) return thumbnail.status();
      job_.thumbnails.push_back(*std::move(thumbnail));
    }
    return absl::OkStatus();
  }

  absl::Status CutLayers() {
    std::vector<SweepScratch> scratch(static_cast<size_t>(std::max(call_.threads, 1)));
    ForEachIndex(call_.threads, job_.layers.size(), [&](size_t layer, int worker) {
      if (call_.cancel.Cancelled()) return;
      for (ObjectSection& section : job_.layers[layer].sections)
        CutSection(scratch[static_cast<size_t>(worker)], section);
    });
    if (call_.cancel.Cancelled()) return call_.cancel.Check();
    ChangeHoles();
    if (call_.cancel.Cancelled()) return call_.cancel.Check();
    for (const SlicedLayer& layer : job_.layers)
      for (const ObjectSection& section : layer.sections)
        if (!section.regions.empty()) return absl::OkStatus();
    return NoOutlines();
  }

  /// Changes outlines that depend on several layers: overhangs, counterbores and polyholes.
  void ChangeHoles() {
    std::vector<std::vector<ObjectSection*>> sections(objects_.size());
    for (SlicedLayer& layer : job_.layers)
      for (ObjectSection& section : layer.sections)
        sections[static_cast<size_t>(section.stack.object)].push_back(&section);
    for (size_t object = 0; object < objects_.size(); ++object) {
      const ObjectSlicingOptions& options = options_.objects[object];
      MakeOverhangsPrintable(options.printable, sections[object], call_.cancel);
      BridgeCounterbores(options.counterbores, sections[object], call_.threads, call_.cancel);
      MakePolyholes(options.polyholes, sections[object], call_.cancel);
    }
  }

  absl::Status NoOutlines() const {
    const bool shrinks = std::ranges::any_of(
        options_.objects,
        [](const ObjectSlicingOptions& object) { return object.xy_compensation_nm < 0; });
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
        std::string("no layer has an outline: the mesh has no volume, or its openings are wider "
                    "than open_loop_max_gap") +
            (shrinks ? ", or xy_size_compensation removes it completely" : ""));
  }

  absl::Status AdviseOrientations() {
    if (!advise_orientations_) return absl::OkStatus();
    for (size_t object = 0; object < objects_.size(); ++object) {
      auto advice =
          AdviseOrientation(SolidsOf(objects_[object]), objects_[object].to_plate, call_.cancel);
      if (!advice.ok()) return advice.status();
      if (!advice->has_value()) continue;
      (*advice)->object = objects_[object].name;
      job_.orientations.push_back(**advice);
    }
    return absl::OkStatus();
  }

  void CutSection(SweepScratch& scratch, ObjectSection& section) {
    SweptObject& object = swept_[static_cast<size_t>(section.stack.object)];
    const size_t range = RangeOf(section);
    std::vector<PartSection> parts;
    bool manifold = true;
    for (SweptPart& swept : object.parts) {
      const PartInput& input = swept.part->input;
      manifold = manifold && (input.role != PartRole::kSolid || swept.part->IsManifold());
      parts.push_back({input.role, input.regions[range], &input.changes,
                       MarkedOrSolid(swept, section, scratch)});
    }
    const ObjectSlicingOptions& slicing = SlicingOf(section);
    PartitionedSection partition = Partition(
        std::move(parts), EditsFor(section.layer, manifold, slicing), options_.resolution_nm);
    section.regions = std::move(partition.regions);
    section.whole = std::move(partition.whole);
    section.marks = std::move(partition.marks);
    if (!object.surface.empty())
      section.surface = std::move(object.surface[static_cast<size_t>(section.layer)]);
    if (section.hollow) KeepLargestContour(section);
  }

  /// Returns the index of the height range that contains the section; the last index is for
  /// sections outside all ranges.
  size_t RangeOf(const ObjectSection& section) const {
    const auto object = static_cast<size_t>(section.stack.object);
    const std::vector<RangeInput>& ranges = objects_[object].ranges;
    const Coord z = swept_[object].planes[static_cast<size_t>(section.layer)].z_nm;
    for (size_t i = 0; i < ranges.size(); ++i)
      if (ranges[i].from_nm <= z && z < ranges[i].to_nm) return i;
    return ranges.size();
  }

  const ObjectSlicingOptions& SlicingOf(const ObjectSection& section) const {
    return options_.objects[static_cast<size_t>(section.stack.object)];
  }

  MultiPolygon MarkedOrSolid(SweptPart& swept, const ObjectSection& section,
                             SweepScratch& scratch) {
    if (swept.part->IsForSeams()) return SeamOutlines(swept, section, scratch);
    if (!swept.part->IsMarkedSurface()) return Outlines(swept, section, scratch);
    const auto layer = static_cast<size_t>(section.layer);
    const Coord reach_nm = SupportReach(EditsFor(section.layer, true, SlicingOf(section)));
    // An enforcer with a hole in its mesh still counts as a body. Therefore its outlines are added.
    return Union(Outlines(swept, section, scratch),
                 swept.slabs->Shadow(layer, reach_nm, call_.cancel));
  }

  MultiPolygon SeamOutlines(SweptPart& swept, const ObjectSection& section, SweepScratch& scratch) {
    const Coord reach_nm = SeamReach(EditsFor(section.layer, true, SlicingOf(section)));
    if (!swept.part->IsMarkedSurface())
      return AroundBody(Outlines(swept, section, scratch), reach_nm);
    const auto layer = static_cast<size_t>(section.layer);
    const MultiPolygon level = swept.slabs->Shadow(layer, reach_nm, call_.cancel);
    MultiPolygon cut = AroundSurface(swept.sweep.Cut(layer, scratch), reach_nm,
                                     options_.resolution_nm, call_.cancel);
    return level.empty() ? cut : Union(cut, level);
  }

  MultiPolygon Outlines(SweptPart& swept, const ObjectSection& section, SweepScratch& scratch) {
    const auto layer = static_cast<size_t>(section.layer);
    Section cut = swept.sweep.Cut(layer, scratch);
    ClosedChains closed = CloseChains(std::move(cut.chains), options_.max_gap_nm);
    swept.gaps[layer] = closed.counts;
    std::move(closed.loops.begin(), closed.loops.end(), std::back_inserter(cut.loops));
    const ObjectSlicingOptions& slicing = SlicingOf(section);
    MultiPolygon region = RegionOf(cut.loops, slicing.fill_rule, options_.resolution_nm);
    return slicing.close_holes ? WithoutHoles(region) : region;
  }

  absl::Status CountOverlaps() {
    std::vector<Copies> all;
    for (const PreparedObject& object : objects_) all.push_back({&object.footprint, object.shifts});
    std::vector<Coord> lifts;
    for (const ObjectSlicingOptions& object : options_.objects) lifts.push_back(object.lift_nm);
    const bool alike =
        std::ranges::adjacent_find(lifts, std::ranges::not_equal_to{}) == lifts.end();
    std::vector<SlicedLayer> lifted;  // in final positions: some on rafts, some not
    if (!alike) lifted = PrintLayers(job_.layers, lifts, {});
    absl::StatusOr<std::vector<int64_t>> counts =
        CountOverlapping(alike ? job_.layers : lifted, all, call_.cancel);
    if (!counts.ok()) return counts.status();
    overlapping_ = *std::move(counts);
    return absl::OkStatus();
  }

  SlicedJob Result() {
    for (size_t i = 0; i < objects_.size(); ++i) {
      PreparedObject& object = objects_[i];
      for (SweptPart& swept : swept_[i].parts) {
        // Marked surfaces have no report: open edges are a defect of a body but normal for a
        // surface.
        if (swept.part->IsMarkedSurface()) continue;
        MeshReport report = ReportOf(swept, options_.objects[i]);
        if (&swept == &swept_[i].parts.front()) {
          report.overlapping_copies = overlapping_[i];
          report.copies_off_bed = object.copies_off_bed;
        }
        job_.meshes.push_back(std::move(report));
      }
      for (const Point shift : object.shifts)
        job_.copies.push_back({static_cast<int32_t>(i), shift, Moved(object.footprint, shift)});
      job_.object_names.push_back(std::move(object.name));
    }
    return std::move(job_);
  }

  static MeshReport ReportOf(const SweptPart& swept, const ObjectSlicingOptions& slicing) {
    GapCounts total;
    for (const GapCounts& gaps : swept.gaps) total.Add(gaps);
    MeshReport report = swept.part->report;
    report.open_loops_closed = total.closed;
    report.open_loops_dropped = total.dropped;
    report.largest_gap_closed_mm = ToMm(total.largest_gap_nm);
    report.dropped_length_mm = ToMm(total.dropped_length_nm);
    if (!swept.part->IsManifold()) report.cracks_closed_mm = ToMm(2 * slicing.closing_radius_nm);
    return report;
  }

  const StageCall& call_;
  const MeshSource& source_;
  const SlicingOptions& options_;
  bool advise_orientations_ = false;
  SlicedJob job_;
  std::vector<PreparedObject> objects_;
  /// Number of overlapping copies, indexed by object; see CountOverlapping.
  std::vector<int64_t> overlapping_;
  int64_t points_ = 0;              ///< number of points in the sections of the swept parts
  int64_t facets_ = 0;              ///< number of facets of all sections
  std::vector<SweptObject> swept_;  ///< sweeps of the parts, indexed by object
};

class LocalSlicing : public SlicingStage {
 public:
  explicit LocalSlicing(std::unique_ptr<const MeshSource> source) : source_(std::move(source)) {}

  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions& options) const override {
    return SlicingRun(call, *source_, options).Run(std::move(input));
  }

 private:
  const std::unique_ptr<const MeshSource> source_;
};

}  // namespace

std::unique_ptr<SlicingStage> MakeLocalSlicing(std::unique_ptr<const MeshSource> source) {
  return std::make_unique<LocalSlicing>(std::move(source));
}

}  // namespace slicefarm::slicing
