// Tests that the bytes of a job do not depend on its division into ranges of layers, or on the
// number of threads. All features that connect layers are switched on.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/config/plate.h"
#include "common/stage/object_layers.h"
#include "common/stage/print_layers.h"
#include "processes/fdm/task/fdm_shared.h"
#include "processes/fdm/task/layer_chain.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/planning/algo/local_planning_stage.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"

namespace slicefarm::any_cut_test {
namespace {

using Pairs = std::vector<std::pair<std::string, std::string>>;

std::vector<Setting> SettingsOf(const Pairs& pairs) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : pairs) settings.push_back({key, value, Source::kRequest});
  return settings;
}

/// Returns a frustum as an OBJ file: the box from `a` to `b` at its bottom, grown by `more_mm` at
/// its top.
std::string Frustum(Eigen::Vector3d a, Eigen::Vector3d b, double more_mm = 0) {
  std::string text;
  for (const auto& [z, more] : {std::pair(a.z(), 0.0), std::pair(b.z(), more_mm)})
    for (const auto& [x, y] : {std::pair(a.x() - more, a.y() - more),
                               {b.x() + more, a.y() - more},
                               {b.x() + more, b.y() + more},
                               {a.x() - more, b.y() + more}})
      text += fmt::format("v {} {} {}\n", x, y, z);
  for (const char* face : {"4 3 2 1", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"})
    text += fmt::format("f {}\n", face);
  return text;
}

/// Plate of two objects with settings of their own. One is a slab on a post with an enforcer below
/// its edge and a modifier, twice. The second is a cup that leans outwards, on a base.
class Plate {
 public:
  Plate() {
    SceneObject& slab = Add("slab", {{"support_material_style", "grid"}, {"ironing", "1"}});
    AddPart(slab, Frustum({8, 8, 0}, {12, 12, 5}));
    AddPart(slab, Frustum({0, 0, 4}, {20, 20, 7}));
    AddPart(slab, Frustum({0, 0, 3}, {4, 20, 4.5}), PartRole::kSupportEnforcer);
    AddPart(slab, Frustum({10, -1, -1}, {21, 21, 9}), PartRole::kModifier,
            {{"fuzzy_skin", "external"}, {"perimeters", "4"}});
    Stand(slab, 40, 40);
    Stand(slab, 40, 90);
    SceneObject& cup = Add("cup", {{"support_material_style", "organic"},
                                   {"adaptive_layer_height", "1"},
                                   {"scarf_seam_placement", "everywhere"},
                                   {"scarf_seam_only_on_smooth", "0"},
                                   {"layer_height", "0.07"},
                                   {"brim_width", "2"}});
    AddPart(cup, Frustum({4, 4, 0}, {16, 16, 5}, 7));
    AddPart(cup, Frustum({-8, 6, 6}, {28, 14, 7}));
    Stand(cup, 100, 60);
  }

  const std::vector<MeshFile>& files() const { return files_; }
  const std::vector<SceneObject>& objects() const { return objects_; }

 private:
  SceneObject& Add(const std::string& name, const Pairs& own) {
    objects_.reserve(2);
    SceneObject& object = objects_.emplace_back();
    object.name = name;
    object.settings = SettingsOf(own);
    return object;
  }

  void AddPart(SceneObject& object, std::string mesh, PartRole role = PartRole::kSolid,
               const Pairs& own = {}) {
    Part& part = object.parts.emplace_back();
    part.mesh.file = static_cast<int32_t>(files_.size());
    part.role = role;
    part.settings = SettingsOf(own);
    files_.push_back({object.name, MeshFormat::kObj, std::move(mesh)});
  }

  static void Stand(SceneObject& object, double x_mm, double y_mm) {
    Instance& instance = object.instances.emplace_back();
    instance.to_plate(0, 3) = x_mm;
    instance.to_plate(1, 3) = y_mm;
  }

  std::vector<MeshFile> files_;
  std::vector<SceneObject> objects_;
};

const Pairs kJob = {{"support_material", "1"},
                    {"layer_height", "0.06"},
                    {"first_layer_height", "0.2"},
                    {"avoid_crossing_perimeters", "1"},
                    {"avoid_crossing_curled_overhangs", "1"},
                    {"enable_dynamic_overhang_speeds", "1"},
                    {"skirts", "1"},
                    {"fill_pattern", "lightning"},
                    {"seam_position", "aligned"},
                    {"infill_every_layers", "2"},
                    {"wipe", "1"},
                    {"thumbnails", ""},
                    {"gcode_label_objects", "octoprint"},
                    {"thick_bridges", "1"}};

/// A job between planning and its ranges.
class PlannedPrint {
 public:
  explicit PlannedPrint(int threads) {
    const Plate plate;
    auto resolved = config::ResolvePlate(SettingsOf(kJob), plate.objects(), Process::kFdm);
    EXPECT_TRUE(resolved.ok()) << resolved.status();
    if (!resolved.ok()) return;
    settings_ = FdmOf(resolved->settings);
    StageCall call;
    call.threads = threads;
    auto sliced =
        slicing::MakeLocalSlicing(slicing::MakeDirectMeshSource())
            ->Slice(call, {plate.files(), resolved->objects, false}, resolved->settings.slicing);
    EXPECT_TRUE(sliced.ok()) << sliced.status();
    if (!sliced.ok()) return;
    auto plan = planning::MakeLocalPlanning()->Plan(
        call, {sliced->layers, sliced->copies, sliced->object_names}, PlanningOf(settings_));
    EXPECT_TRUE(plan.ok()) << plan.status();
    if (!plan.ok()) return;
    layers_ = PrintLayers(std::move(sliced->layers), plan->lifts_nm, std::move(plan->stacks));
    for (int32_t i = 0; i < plan->skirt.layers; ++i)
      plan->layers[static_cast<size_t>(i)].paths = plan->skirt.loops;
    plan_ = *std::move(plan);
  }

  int32_t layers() const { return static_cast<int32_t>(layers_.size()); }

  std::string Gcode(int32_t range_layers) const {
    std::string gcode;
    for (int32_t first = 0; first < layers(); first += range_layers)
      gcode += GcodeOf({first, std::min(layers(), first + range_layers)});
    return gcode;
  }

 private:
  std::string GcodeOf(const LayerRange& range) const {
    const auto at = [](int32_t index) { return static_cast<size_t>(index); };
    const LayerRange halo = WithHalo(layers_, range, HaloLayers(settings_));
    const FdmTask task{.range = range,
                       .layers = std::span(layers_).subspan(at(halo.first), at(halo.size())),
                       .plans = std::span(plan_.layers).subspan(at(range.first), at(range.size())),
                       .job = FdmShared{settings_, plan_.copies, JobFacts{layers(), {}, {}}}};
    const auto result = LayerChain{*beading_, *infill_, *ordering_, *motion_}.Run({}, task);
    EXPECT_TRUE(result.ok()) << result.status();
    std::string gcode;
    if (result.ok())
      for (const LayerProgram& program : result->programs) gcode += program.gcode;
    return gcode;
  }

  FdmSettings settings_;
  std::vector<SlicedLayer> layers_;
  JobPlan plan_;
  const std::unique_ptr<BeadingStage> beading_ = beading::MakeLocalBeading();
  const std::unique_ptr<InfillStage> infill_ = infill::MakeLocalInfill();
  const std::unique_ptr<OrderingStage> ordering_ = ordering::MakeLocalOrdering();
  const std::unique_ptr<MotionStage> motion_ = motion::MakeLocalMotion();
};

TEST(AnyCut, GivesTheSameBytes) {
  const PlannedPrint print(1);
  ASSERT_GT(print.layers(), 128);
  const std::string whole = print.Gcode(print.layers());
  for (const char* type : {"Skirt/Brim", "Support material\n", "Support material interface",
                           "Ironing", "Bridge infill", "Internal infill"})
    EXPECT_NE(whole.find(std::string(";TYPE:") + type), std::string::npos) << type;
  for (const int32_t layers : {1, 7, 128})
    EXPECT_TRUE(print.Gcode(layers) == whole) << "ranges of " << layers;
  EXPECT_TRUE(PlannedPrint(1).Gcode(128) == whole) << "once more";
  for (const int threads : {2, 8})
    EXPECT_TRUE(PlannedPrint(threads).Gcode(7) == whole) << threads << " threads";
}

}  // namespace
}  // namespace slicefarm::any_cut_test
