#include "services/slicing/algo/local_slicing_stage.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/geometry/moved.h"
#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/placement/footprint.h"
#include "services/slicing/algo/section/layer_heights.h"
#include "services/slicing/algo/section/open_loops.h"
#include "services/slicing/algo/parallel.h"
#include "services/slicing/algo/placement/prepared_mesh.h"
#include "services/slicing/algo/section/regions.h"
#include "services/slicing/algo/section/sweep.h"
#include "services/slicing/algo/thumbnail/thumbnail.h"

namespace slicefarm::slicing {
namespace {

/// More triangles than this are not drawn as many times as there are copies.
constexpr int64_t kMaxDrawnTriangles = 2'000'000;

absl::Status CheckInput(const SliceInput& input) {
  if (input.files.empty() || input.files.size() != input.placements.size())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     "a job needs one placement for each of its meshes, and at least one mesh");
  int64_t objects = 0;
  for (const Placement& placement : input.placements)
    objects += static_cast<int64_t>(std::max<size_t>(placement.centers.size(), 1));
  if (objects > limits::kMaxObjects)
    return LimitError(Reason::kRequestTooLarge, "objects, copies included", limits::kMaxObjects,
                      objects);
  return absl::OkStatus();
}

/// One run of the stage.
class SlicingRun {
 public:
  SlicingRun(const StageCall& call, const MeshSource& source, const SlicingOptions& options)
      : call_(call), source_(source), options_(options) {}

  absl::StatusOr<SlicedJob> Run(SliceInput input) {
    for (auto step : {&SlicingRun::Prepare, &SlicingRun::Plan, &SlicingRun::Draw})
      if (absl::Status status = (this->*step)(input); !status.ok()) return status;
    if (absl::Status status = CutLayers(); !status.ok()) return status;
    return Result();
  }

 private:
  absl::Status Prepare(SliceInput& input) {
    for (const MeshFile& file : input.files) names_.push_back(file.name);
    for (size_t i = 0; i < input.files.size(); ++i) {
      absl::StatusOr<PreparedMesh> mesh = PrepareMesh(std::exchange(input.files[i], {}), source_,
                                                      input.placements[i], options_, call_.cancel);
      if (!mesh.ok()) return OfFile(i, mesh.status());
      meshes_.push_back(*std::move(mesh));
    }
    return absl::OkStatus();
  }

  /// The error with its file in front, where there are several to look at.
  absl::Status OfFile(size_t file, const absl::Status& status) const {
    if (names_.size() == 1 || absl::IsCancelled(status)) return status;
    ErrorDetail detail = DetailOf(status);
    detail.metadata["file"] = absl::StrCat(file);
    // The name is the user's and may hold anything.
    const std::string name = absl::Utf8SafeCEscape(names_[file]);
    return MakeError(status.code(), detail.reason,
                     absl::StrCat("file ", file, " (\"", name, "\"): ", status.message()),
                     std::move(detail.metadata));
  }

  absl::Status Plan(SliceInput&) {
    Coord top = 0;
    for (const PreparedMesh& mesh : meshes_)
      for (const Vertex& v : mesh.connected.mesh.vertices) top = std::max(top, v.z);
    absl::StatusOr<std::vector<LayerPlane>> planes = LayerPlanes(top, options_);
    if (!planes.ok()) return planes.status();
    std::vector<Coord> heights;
    for (const LayerPlane& plane : *planes) {
      job_.layers.push_back({plane.frame, {}});
      heights.push_back(plane.z_nm);
    }
    for (const PreparedMesh& mesh : meshes_) {
      absl::StatusOr<Sweep> sweep = Sweep::Prepare(mesh.connected, heights);
      if (!sweep.ok()) return OfFile(sweeps_.size(), sweep.status());
      sweeps_.push_back(*std::move(sweep));
    }
    return CheckPointsPerLayer();
  }

  absl::Status CheckPointsPerLayer() const {
    for (size_t layer = 0; layer < job_.layers.size(); ++layer) {
      int64_t points = 0;
      for (size_t i = 0; i < meshes_.size(); ++i)
        points += sweeps_[i].segments(layer) * static_cast<int64_t>(meshes_[i].centers.size());
      if (points > limits::kMaxPointsPerLayer)
        return LimitError(Reason::kMeshTooLarge, "points in a layer, copies included",
                          limits::kMaxPointsPerLayer, points);
    }
    return absl::OkStatus();
  }

  absl::Status Draw(SliceInput&) {
    int64_t triangles = 0;
    for (const PreparedMesh& mesh : meshes_)
      triangles += mesh.report.triangles * static_cast<int64_t>(mesh.centers.size());
    const bool all_copies = triangles <= kMaxDrawnTriangles;
    std::vector<SceneObject> scene;
    for (const PreparedMesh& mesh : meshes_) {
      const bool solid = mesh.connected.closed && mesh.report.volume_mm3 > 0;
      for (size_t copy = 0; copy < (all_copies ? mesh.centers.size() : 1); ++copy)
        scene.push_back({&mesh.connected.mesh, mesh.centers[copy], solid});
    }
    for (const auto& size_px : options_.thumbnails_px) {
      absl::StatusOr<Thumbnail> thumbnail = RenderThumbnail(scene, size_px, call_.cancel);
      if (!thumbnail.ok()) return thumbnail.status();
      job_.thumbnails.push_back(*std::move(thumbnail));
    }
    return absl::OkStatus();
  }

  absl::Status CutLayers() {
    counts_.assign(job_.layers.size(), std::vector<GapCounts>(meshes_.size()));
    std::vector<SweepScratch> scratch(static_cast<size_t>(std::max(call_.threads, 1)));
    ForEachIndex(call_.threads, job_.layers.size(), [&](size_t layer, int worker) {
      if (!call_.cancel.Cancelled()) CutLayer(layer, scratch[static_cast<size_t>(worker)]);
    });
    if (call_.cancel.Cancelled()) return call_.cancel.Check();
    for (const SlicedLayer& layer : job_.layers)
      if (!layer.objects.empty()) return absl::OkStatus();
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                     "no layer has an outline: the mesh has no volume, or its openings are wider "
                     "than open_loop_max_gap");
  }

  void CutLayer(size_t layer, SweepScratch& scratch) {
    SlicedLayer& sliced = job_.layers[layer];
    int32_t object = 0;
    for (size_t i = 0; i < meshes_.size(); ++i) {
      MultiPolygon outlines = Outlines(i, layer, scratch);
      for (const Point center : meshes_[i].centers) {
        if (!outlines.empty()) sliced.objects.push_back({object, Moved(outlines, center)});
        ++object;
      }
    }
  }

  /// Every edge has two faces: its sections need no closing of cracks. Parts that touch along edges
  /// are not manifold: what little keeps them apart is taken for the crack that it is.
  bool IsManifold(size_t mesh) const {
    return meshes_[mesh].connected.closed && meshes_[mesh].report.non_manifold_edges == 0;
  }

  MultiPolygon Outlines(size_t mesh, size_t layer, SweepScratch& scratch) {
    Section section = sweeps_[mesh].Cut(layer, scratch);
    ClosedChains closed = CloseChains(std::move(section.chains), options_.max_gap_nm);
    counts_[layer][mesh] = closed.counts;
    std::move(closed.loops.begin(), closed.loops.end(), std::back_inserter(section.loops));
    const RegionEdits edits = EditsFor(static_cast<int32_t>(layer), IsManifold(mesh), options_);
    return Edited(RegionOf(section.loops, options_.fill_rule, options_.resolution_nm), edits,
                  options_.resolution_nm);
  }

  void ReportOverlaps() {
    std::vector<Polygon> footprints;
    for (const PreparedMesh& mesh : meshes_) footprints.push_back(Footprint(mesh.connected.mesh));
    std::vector<Copies> parts;
    for (size_t i = 0; i < meshes_.size(); ++i)
      parts.push_back({&footprints[i], meshes_[i].centers});
    const std::vector<int64_t> overlapping = CountOverlapping(parts);
    for (size_t i = 0; i < meshes_.size(); ++i)
      meshes_[i].report.overlapping_copies = overlapping[i];
  }

  SlicedJob Result() {
    const bool one = meshes_.size() == 1 && meshes_[0].centers.size() == 1;
    if (!one) ReportOverlaps();
    for (size_t i = 0; i < meshes_.size(); ++i) {
      GapCounts total;
      for (const auto& by_mesh : counts_) total.Add(by_mesh[i]);
      MeshReport& report = meshes_[i].report;
      report.open_loops_closed = total.closed;
      report.open_loops_dropped = total.dropped;
      report.largest_gap_closed_mm = ToMm(total.largest_gap_nm);
      report.dropped_length_mm = ToMm(total.dropped_length_nm);
      if (!IsManifold(i)) report.cracks_closed_mm = ToMm(2 * options_.closing_radius_nm);
      job_.object_names.insert(job_.object_names.end(), meshes_[i].centers.size(), report.name);
      job_.meshes.push_back(std::move(report));
    }
    return std::move(job_);
  }

  const StageCall& call_;
  const MeshSource& source_;
  const SlicingOptions& options_;
  SlicedJob job_;
  std::vector<std::string> names_;  ///< of the files
  std::vector<PreparedMesh> meshes_;
  std::vector<Sweep> sweeps_;
  std::vector<std::vector<GapCounts>> counts_;  ///< by layer, by mesh
};

class LocalSlicing : public SlicingStage {
 public:
  explicit LocalSlicing(std::unique_ptr<const MeshSource> source) : source_(std::move(source)) {}

  absl::StatusOr<SlicedJob> Slice(const StageCall& call, SliceInput input,
                                  const SlicingOptions& options) const override {
    if (absl::Status status = CheckInput(input); !status.ok()) return status;
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
