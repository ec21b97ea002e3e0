#include "common/wire/options/planning_options_wire.h"

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "common/model/limits.h"
#include "common/wire/geometry_wire.h"
#include "common/wire/options/settings_check.h"
#include "common/wire/options/settings_wire.h"
#include "common/wire/options/skin_spare_wire.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

static_assert(v1::SEAM_POSITION_NEAREST == static_cast<int>(SeamPosition::kNearest) + 1);
static_assert(v1::SEAM_POSITION_REAR == static_cast<int>(SeamPosition::kRear) + 1);
static_assert(v1::SEAM_POSITION_ALIGNED == static_cast<int>(SeamPosition::kAligned) + 1);
static_assert(v1::SEAM_POSITION_RANDOM == static_cast<int>(SeamPosition::kRandom) + 1);
static_assert(v1::SEAM_POSITION_HIDDEN == static_cast<int>(SeamPosition::kHidden) + 1);
static_assert(v1::DRAFT_SHIELD_DISABLED == static_cast<int>(DraftShield::kDisabled) + 1);
static_assert(v1::DRAFT_SHIELD_LIMITED == static_cast<int>(DraftShield::kLimited) + 1);
static_assert(v1::DRAFT_SHIELD_ENABLED == static_cast<int>(DraftShield::kEnabled) + 1);
static_assert(v1::BRIM_TYPE_NONE == static_cast<int>(BrimType::kNone) + 1);
static_assert(v1::BRIM_TYPE_OUTER_ONLY == static_cast<int>(BrimType::kOuterOnly) + 1);
static_assert(v1::BRIM_TYPE_INNER_ONLY == static_cast<int>(BrimType::kInnerOnly) + 1);
static_assert(v1::BRIM_TYPE_OUTER_AND_INNER == static_cast<int>(BrimType::kOuterAndInner) + 1);
static_assert(v1::BRIM_TYPE_EARS == static_cast<int>(BrimType::kEars) + 1);

static_assert(v1::SUPPORT_STYLE_GRID == static_cast<int>(SupportStyle::kGrid) + 1);
static_assert(v1::SUPPORT_STYLE_SNUG == static_cast<int>(SupportStyle::kSnug) + 1);
static_assert(v1::SUPPORT_STYLE_TREE == static_cast<int>(SupportStyle::kTree) + 1);
static_assert(v1::SUPPORT_PATTERN_RECTILINEAR ==
              static_cast<int>(SupportPattern::kRectilinear) + 1);
static_assert(v1::SUPPORT_PATTERN_RECTILINEAR_GRID ==
              static_cast<int>(SupportPattern::kRectilinearGrid) + 1);
static_assert(v1::SUPPORT_PATTERN_HONEYCOMB == static_cast<int>(SupportPattern::kHoneycomb) + 1);
static_assert(v1::INTERFACE_PATTERN_RECTILINEAR ==
              static_cast<int>(InterfacePattern::kRectilinear) + 1);
static_assert(v1::INTERFACE_PATTERN_CONCENTRIC ==
              static_cast<int>(InterfacePattern::kConcentric) + 1);

absl::Status CheckRow(std::string_view field, int32_t row) {
  if (0 <= row && row < limits::kMaxRegionSettings) return absl::OkStatus();
  return Malformed(field, "is no row of a table of region settings");
}

absl::Status CheckCount(std::string_view field, int64_t count, int64_t most) {
  if (0 <= count && count <= most) return absl::OkStatus();
  return Malformed(field, "is out of range");
}

v1::SkirtOptions ToProto(const SkirtOptions& options) {
  v1::SkirtOptions proto;
  proto.set_loops(options.loops);
  proto.set_distance_nm(options.distance_nm);
  proto.set_min_length_nm(options.min_length_nm);
  proto.set_height_layers(options.height_layers);
  proto.set_draft_shield(EnumToProto<v1::DraftShield>(options.draft_shield));
  proto.set_width_nm(options.width_nm);
  proto.set_height_nm(options.height_nm);
  proto.set_filament_area_mm2(options.filament_area_mm2);
  return proto;
}

absl::StatusOr<SkirtOptions> SkirtFromProto(const v1::SkirtOptions& proto) {
  absl::Status status = CheckCount("loops", proto.loops(), limits::kMaxSkirtLoops);
  status.Update(CheckCount("height_layers", proto.height_layers(), limits::kMaxLayers));
  status.Update(CheckNotNegative({{"distance_nm", proto.distance_nm()}}));
  status.Update(CheckPositive({{"width_nm", proto.width_nm()}, {"height_nm", proto.height_nm()}}));
  if (proto.min_length_nm() < 0) status.Update(Malformed("min_length_nm", "is negative"));
  if (!(proto.filament_area_mm2() > 0)) {
    status.Update(Malformed("filament_area_mm2", "is not above 0"));
  }
  if (!status.ok()) return status;
  return SkirtOptions{.loops = proto.loops(),
                      .distance_nm = proto.distance_nm(),
                      .min_length_nm = proto.min_length_nm(),
                      .height_layers = proto.height_layers(),
                      .draft_shield = Known<DraftShield>(proto.draft_shield()),
                      .width_nm = proto.width_nm(),
                      .height_nm = proto.height_nm(),
                      .filament_area_mm2 = proto.filament_area_mm2()};
}

v1::BrimOptions ToProto(const BrimOptions& options) {
  v1::BrimOptions proto;
  proto.set_type(EnumToProto<v1::BrimType>(options.type));
  proto.mutable_automatic()->set_on(options.automatic.on);
  proto.mutable_automatic()->set_thermal_length_mm(options.automatic.thermal_length_mm);
  proto.mutable_automatic()->set_adhesion(options.automatic.adhesion);
  proto.mutable_automatic()->set_max_speed_mm_s(options.automatic.max_speed_mm_s);
  proto.set_width_nm(options.width_nm);
  proto.set_separation_nm(options.separation_nm);
  proto.set_line_width_nm(options.line_width_nm);
  proto.set_ear_max_angle_rad(options.ear_max_angle_rad);
  proto.set_ear_detection_nm(options.ear_detection_nm);
  return proto;
}

absl::StatusOr<BrimOptions> BrimFromProto(const v1::BrimOptions& proto) {
  absl::Status status = CheckNotNegative({{"width_nm", proto.width_nm()},
                                          {"separation_nm", proto.separation_nm()},
                                          {"ear_detection_nm", proto.ear_detection_nm()}});
  status.Update(CheckPositive({{"line_width_nm", proto.line_width_nm()}}));
  if (!(0 <= proto.ear_max_angle_rad() && proto.ear_max_angle_rad() < 2 * std::numbers::pi)) {
    status.Update(Malformed("ear_max_angle_rad", "is out of range"));
  }
  const v1::AutomaticBrim& automatic = proto.automatic();
  if (!(automatic.thermal_length_mm() > 0 && automatic.adhesion() >= 0 &&
        automatic.max_speed_mm_s() >= 0)) {
    status.Update(Malformed("automatic", "is out of range"));
  }
  if (!status.ok()) return status;
  return BrimOptions{.type = Known<BrimType>(proto.type()),
                     .automatic = {automatic.on(), automatic.thermal_length_mm(),
                                   automatic.adhesion(), automatic.max_speed_mm_s()},
                     .width_nm = proto.width_nm(),
                     .separation_nm = proto.separation_nm(),
                     .line_width_nm = proto.line_width_nm(),
                     .ear_max_angle_rad = proto.ear_max_angle_rad(),
                     .ear_detection_nm = proto.ear_detection_nm()};
}

v1::RaftLines ToProto(const RaftLines& lines) {
  v1::RaftLines proto;
  proto.set_width_nm(lines.width_nm);
  proto.set_spacing_nm(lines.spacing_nm);
  proto.set_angle_rad(lines.angle_rad);
  proto.set_first_layer_density(lines.first_layer_density);
  return proto;
}

absl::StatusOr<RaftLines> LinesFromProto(const v1::RaftLines& proto) {
  absl::Status status = CheckPositive({{"width_nm", proto.width_nm()}});
  status.Update(CheckNotNegative({{"spacing_nm", proto.spacing_nm()}}));
  if (!(0 <= proto.first_layer_density() && proto.first_layer_density() <= 1)) {
    status.Update(Malformed("first_layer_density", "is not in [0, 1]"));
  }
  if (!status.ok()) return status;
  return RaftLines{proto.width_nm(), proto.spacing_nm(), proto.angle_rad(),
                   proto.first_layer_density()};
}

v1::RaftHeights ToProto(const RaftHeights& heights) {
  v1::RaftHeights proto;
  proto.set_layers(heights.layers);
  proto.set_first_nm(heights.first_nm);
  proto.set_others_nm(heights.others_nm);
  proto.set_contact_distance_nm(heights.contact_distance_nm);
  return proto;
}

absl::StatusOr<RaftHeights> HeightsFromProto(const v1::RaftHeights& proto) {
  absl::Status status = CheckCount("layers", proto.layers(), limits::kMaxRaftLayers);
  status.Update(CheckPositive({{"first_nm", proto.first_nm()}, {"others_nm", proto.others_nm()}}));
  status.Update(CheckNotNegative({{"contact_distance_nm", proto.contact_distance_nm()}}));
  if (!status.ok()) return status;
  return RaftHeights{proto.layers(), proto.first_nm(), proto.others_nm(),
                     proto.contact_distance_nm()};
}

v1::RaftOptions ToProto(const RaftOptions& options) {
  v1::RaftOptions proto;
  *proto.mutable_lines() = ToProto(options.lines);
  *proto.mutable_heights() = ToProto(options.heights);
  proto.set_expansion_nm(options.expansion_nm);
  proto.set_first_layer_expansion_nm(options.first_layer_expansion_nm);
  return proto;
}

absl::StatusOr<RaftOptions> RaftFromProto(const v1::RaftOptions& proto) {
  absl::Status status =
      CheckNotNegative({{"expansion_nm", proto.expansion_nm()},
                        {"first_layer_expansion_nm", proto.first_layer_expansion_nm()}});
  if (!status.ok()) return status;
  const absl::StatusOr<RaftHeights> heights = HeightsFromProto(proto.heights());
  if (!heights.ok()) return Within("heights", heights.status());
  const absl::StatusOr<RaftLines> lines = LinesFromProto(proto.lines());
  if (!lines.ok()) return Within("lines", lines.status());
  return RaftOptions{*heights, *lines, proto.expansion_nm(), proto.first_layer_expansion_nm()};
}

v1::TreeOptions ToProto(const TreeOptions& options) {
  v1::TreeOptions proto;
  proto.set_angle_rad(options.angle_rad);
  proto.set_slow_angle_rad(options.slow_angle_rad);
  proto.set_branch_diameter_nm(options.branch_diameter_nm);
  proto.set_diameter_angle_rad(options.diameter_angle_rad);
  proto.set_double_wall_diameter_nm(options.double_wall_diameter_nm);
  proto.set_tip_diameter_nm(options.tip_diameter_nm);
  proto.set_branch_distance_nm(options.branch_distance_nm);
  proto.set_top_rate(options.top_rate);
  return proto;
}

absl::StatusOr<TreeOptions> TreeFromProto(const v1::TreeOptions& proto) {
  absl::Status status = CheckPositive({{"branch_diameter_nm", proto.branch_diameter_nm()},
                                       {"tip_diameter_nm", proto.tip_diameter_nm()},
                                       {"branch_distance_nm", proto.branch_distance_nm()}});
  status.Update(CheckNotNegative({{"double_wall_diameter_nm", proto.double_wall_diameter_nm()}}));
  for (const double angle_rad :
       {proto.angle_rad(), proto.slow_angle_rad(), proto.diameter_angle_rad()})
    if (!(0 <= angle_rad && angle_rad < std::numbers::pi / 2))
      status.Update(Malformed("angle_rad", "is not of a branch"));
  if (!(0 <= proto.top_rate() && proto.top_rate() <= 1))
    status.Update(Malformed("top_rate", "is not in [0, 1]"));
  if (!status.ok()) return status;
  return TreeOptions{.angle_rad = proto.angle_rad(),
                     .slow_angle_rad = proto.slow_angle_rad(),
                     .branch_diameter_nm = proto.branch_diameter_nm(),
                     .diameter_angle_rad = proto.diameter_angle_rad(),
                     .double_wall_diameter_nm = proto.double_wall_diameter_nm(),
                     .tip_diameter_nm = proto.tip_diameter_nm(),
                     .branch_distance_nm = proto.branch_distance_nm(),
                     .top_rate = proto.top_rate()};
}

v1::SupportOptions ToProto(const SupportOptions& options) {
  v1::SupportOptions proto;
  proto.set_on(options.on);
  proto.set_automatic(options.automatic);
  proto.set_style(EnumToProto<v1::SupportStyle>(options.style));
  proto.set_threshold_rad(options.threshold_rad);
  proto.set_enforced_layers(options.enforced_layers);
  proto.set_bed_only(options.bed_only);
  proto.set_skip_bridges(options.skip_bridges);
  proto.set_top_gap_nm(options.top_gap_nm);
  proto.set_bottom_gap_nm(options.bottom_gap_nm);
  proto.set_xy_gap_nm(options.xy_gap_nm);
  proto.set_closing_radius_nm(options.closing_radius_nm);
  proto.set_top_interface_layers(options.top_interface_layers);
  proto.set_bottom_interface_layers(options.bottom_interface_layers);
  proto.set_spacing_nm(options.spacing_nm);
  proto.set_interface_spacing_nm(options.interface_spacing_nm);
  proto.set_pattern(EnumToProto<v1::SupportPattern>(options.pattern));
  proto.set_interface_pattern(EnumToProto<v1::InterfacePattern>(options.interface_pattern));
  proto.set_angle_rad(options.angle_rad);
  proto.set_sheath(options.sheath);
  proto.set_width_nm(options.width_nm);
  proto.set_wall_width_nm(options.wall_width_nm);
  proto.set_walls_nm(options.walls_nm);
  proto.set_layer_height_nm(options.layer_height_nm);
  proto.set_first_layer_height_nm(options.first_layer_height_nm);
  proto.set_min_layer_height_nm(options.min_layer_height_nm);
  proto.set_synchronize_layers(options.synchronize_layers);
  *proto.mutable_tree() = ToProto(options.tree);
  return proto;
}

absl::StatusOr<SupportOptions> SupportFromProto(const v1::SupportOptions& proto) {
  absl::Status status = CheckNotNegative({{"top_gap_nm", proto.top_gap_nm()},
                                          {"bottom_gap_nm", proto.bottom_gap_nm()},
                                          {"xy_gap_nm", proto.xy_gap_nm()},
                                          {"closing_radius_nm", proto.closing_radius_nm()},
                                          {"spacing_nm", proto.spacing_nm()},
                                          {"interface_spacing_nm", proto.interface_spacing_nm()},
                                          {"walls_nm", proto.walls_nm()}});
  status.Update(CheckPositive({{"width_nm", proto.width_nm()},
                               {"wall_width_nm", proto.wall_width_nm()},
                               {"layer_height_nm", proto.layer_height_nm()},
                               {"first_layer_height_nm", proto.first_layer_height_nm()},
                               {"min_layer_height_nm", proto.min_layer_height_nm()}}));
  status.Update(CheckCount("enforced_layers", proto.enforced_layers(), limits::kMaxLayers));
  status.Update(
      CheckCount("top_interface_layers", proto.top_interface_layers(), limits::kMaxLayers));
  status.Update(
      CheckCount("bottom_interface_layers", proto.bottom_interface_layers(), limits::kMaxLayers));
  if (!(0 <= proto.threshold_rad() && proto.threshold_rad() <= std::numbers::pi / 2))
    status.Update(Malformed("threshold_rad", "is out of range"));
  if (!status.ok()) return status;
  const absl::StatusOr<TreeOptions> tree = TreeFromProto(proto.tree());
  if (!tree.ok()) return Within("tree", tree.status());
  return SupportOptions{.on = proto.on(),
                        .automatic = proto.automatic(),
                        .style = Known<SupportStyle>(proto.style()),
                        .threshold_rad = proto.threshold_rad(),
                        .enforced_layers = proto.enforced_layers(),
                        .bed_only = proto.bed_only(),
                        .skip_bridges = proto.skip_bridges(),
                        .top_gap_nm = proto.top_gap_nm(),
                        .bottom_gap_nm = proto.bottom_gap_nm(),
                        .xy_gap_nm = proto.xy_gap_nm(),
                        .closing_radius_nm = proto.closing_radius_nm(),
                        .top_interface_layers = proto.top_interface_layers(),
                        .bottom_interface_layers = proto.bottom_interface_layers(),
                        .spacing_nm = proto.spacing_nm(),
                        .interface_spacing_nm = proto.interface_spacing_nm(),
                        .pattern = Known<SupportPattern>(proto.pattern()),
                        .interface_pattern = Known<InterfacePattern>(proto.interface_pattern()),
                        .angle_rad = proto.angle_rad(),
                        .sheath = proto.sheath(),
                        .width_nm = proto.width_nm(),
                        .wall_width_nm = proto.wall_width_nm(),
                        .walls_nm = proto.walls_nm(),
                        .layer_height_nm = proto.layer_height_nm(),
                        .first_layer_height_nm = proto.first_layer_height_nm(),
                        .min_layer_height_nm = proto.min_layer_height_nm(),
                        .synchronize_layers = proto.synchronize_layers(),
                        .tree = *tree};
}

v1::ObjectPlanOptions ToProto(const ObjectPlanOptions& options) {
  v1::ObjectPlanOptions proto;
  proto.set_seam(EnumToProto<v1::SeamPosition>(options.seam));
  *proto.mutable_brim() = ToProto(options.brim);
  proto.set_brim_settings(options.brim_settings);
  *proto.mutable_raft() = ToProto(options.raft);
  for (const int32_t row : options.raft_settings) proto.add_raft_settings(row);
  *proto.mutable_support() = ToProto(options.support);
  proto.mutable_support_settings()->Assign(options.support_settings.begin(),
                                           options.support_settings.end());
  proto.mutable_spiral()->set_width_nm(options.spiral.width_nm);
  proto.mutable_spiral()->set_blends(options.spiral.blends);
  return proto;
}

absl::StatusOr<ObjectPlanOptions> ObjectFromProto(const v1::ObjectPlanOptions& proto) {
  absl::Status status = CheckComplete(proto);
  status.Update(CheckRow("brim_settings", proto.brim_settings()));
  for (const int32_t row : proto.raft_settings()) status.Update(CheckRow("raft_settings", row));
  if (proto.support_settings_size() != kSupportRowCount)
    status.Update(Malformed("support_settings", "are not one for each kind of region"));
  for (const int32_t row : proto.support_settings())
    status.Update(CheckRow("support_settings", row));
  if (!status.ok()) return status;
  const absl::StatusOr<BrimOptions> brim = BrimFromProto(proto.brim());
  if (!brim.ok()) return Within("brim", brim.status());
  const absl::StatusOr<RaftOptions> raft = RaftFromProto(proto.raft());
  if (!raft.ok()) return Within("raft", raft.status());
  const absl::StatusOr<SupportOptions> support = SupportFromProto(proto.support());
  if (!support.ok()) return Within("support", support.status());
  if (proto.spiral().width_nm() < 0 || proto.spiral().width_nm() > limits::kMaxCoord)
    return Malformed("spiral.width_nm", "is no width");
  ObjectPlanOptions options{
      .seam = Known<SeamPosition>(proto.seam()),
      .brim = *brim,
      .brim_settings = proto.brim_settings(),
      .raft = *raft,
      .raft_settings = {proto.raft_settings().begin(), proto.raft_settings().end()},
      .support = *support,
      .support_settings = {},
      .spiral = {proto.spiral().width_nm(), proto.spiral().blends()}};
  std::ranges::copy(proto.support_settings(), options.support_settings.begin());
  return options;
}

v1::InfillPlanOptions ToProto(const InfillPlanOptions& options) {
  v1::InfillPlanOptions proto;
  proto.set_pattern(EnumToProto<v1::FillPattern>(options.pattern));
  proto.set_choose_pattern(options.choose_pattern);
  proto.set_goal(EnumToProto<v1::FillGoal>(options.goal));
  proto.set_density(options.density);
  proto.set_angle_rad(options.angle_rad);
  proto.set_width_nm(options.width_nm);
  proto.set_walls_nm(options.walls_nm);
  proto.set_top_solid_layers(options.top_solid_layers);
  proto.set_bottom_solid_layers(options.bottom_solid_layers);
  *proto.mutable_top_spare() = ToProto(options.top_spare);
  *proto.mutable_bottom_spare() = ToProto(options.bottom_spare);
  proto.set_interface_shells(options.interface_shells);
  proto.set_every_layers(options.every_layers);
  proto.set_only_where_needed(options.only_where_needed);
  return proto;
}

absl::StatusOr<InfillPlanOptions> InfillFromProto(const v1::InfillPlanOptions& proto) {
  absl::Status status =
      CheckCount("top_solid_layers", proto.top_solid_layers(), limits::kMaxLayers);
  status.Update(CheckCount("bottom_solid_layers", proto.bottom_solid_layers(), limits::kMaxLayers));
  status.Update(CheckSpares(proto));
  status.Update(CheckPositive({{"width_nm", proto.width_nm()}}));
  status.Update(CheckNotNegative({{"walls_nm", proto.walls_nm()}}));
  if (proto.every_layers() < 1) status.Update(Malformed("every_layers", "is below 1"));
  if (!(0 <= proto.density() && proto.density() <= 1))
    status.Update(Malformed("density", "is not in [0, 1]"));
  if (!status.ok()) return status;
  return InfillPlanOptions{.pattern = Known<FillPattern>(proto.pattern()),
                           .choose_pattern = proto.choose_pattern(),
                           .goal = Known<FillGoal>(proto.goal()),
                           .density = proto.density(),
                           .angle_rad = proto.angle_rad(),
                           .width_nm = proto.width_nm(),
                           .walls_nm = proto.walls_nm(),
                           .top_solid_layers = proto.top_solid_layers(),
                           .bottom_solid_layers = proto.bottom_solid_layers(),
                           .top_spare = SpareFromProto(proto.top_spare()),
                           .bottom_spare = SpareFromProto(proto.bottom_spare()),
                           .interface_shells = proto.interface_shells(),
                           .every_layers = proto.every_layers(),
                           .only_where_needed = proto.only_where_needed()};
}

}  // namespace

absl::Status ToProto(const PlanningOptions& options, v1::PlanningOptions* proto) {
  for (const ObjectPlanOptions& object : options.objects) *proto->add_objects() = ToProto(object);
  for (const InfillPlanOptions& infill : options.infill) *proto->add_infill() = ToProto(infill);
  v1::SequencePlanOptions& sequence = *proto->mutable_sequence();
  sequence.set_complete_objects(options.sequence.complete_objects);
  sequence.set_clearance_radius_nm(options.sequence.clearance_radius_nm);
  sequence.set_clearance_height_nm(options.sequence.clearance_height_nm);
  *proto->mutable_skirt() = ToProto(options.skirt);
  proto->set_skirt_settings(options.skirt_settings);
  proto->set_objects_may_overlap(options.objects_may_overlap);
  proto->set_avoid_curled(options.avoid_curled);
  const absl::Status status = ToProto(options.bed, proto->mutable_bed());
  return status.ok() ? status : Within("bed", status);
}

absl::StatusOr<PlanningOptions> FromProto(const v1::PlanningOptions& proto) {
  absl::Status status = CheckRows(proto.objects_size(), "objects");
  if (proto.infill_size() > 0) status.Update(CheckRows(proto.infill_size(), "infill"));
  status.Update(CheckComplete(proto));
  const v1::SequencePlanOptions& sequence = proto.sequence();
  status.Update(CheckNotNegative({{"clearance_radius_nm", sequence.clearance_radius_nm()},
                                  {"clearance_height_nm", sequence.clearance_height_nm()}}));
  status.Update(CheckRow("skirt_settings", proto.skirt_settings()));
  if (!status.ok()) return status;
  PlanningOptions options;
  options.objects.clear();
  for (int i = 0; i < proto.objects_size(); ++i) {
    absl::StatusOr<ObjectPlanOptions> object = ObjectFromProto(proto.objects(i));
    if (!object.ok()) return Within("objects", i, object.status());
    options.objects.push_back(*std::move(object));
  }
  const absl::StatusOr<SkirtOptions> skirt = SkirtFromProto(proto.skirt());
  if (!skirt.ok()) return Within("skirt", skirt.status());
  absl::StatusOr<MultiPolygon> bed = FromProto(proto.bed());
  if (!bed.ok()) return Within("bed", bed.status());
  for (int i = 0; i < proto.infill_size(); ++i) {
    const auto infill = InfillFromProto(proto.infill(i));
    if (!infill.ok()) return Within("infill", i, infill.status());
    options.infill.push_back(*infill);
  }
  options.sequence = {sequence.complete_objects(), sequence.clearance_radius_nm(),
                      sequence.clearance_height_nm()};
  options.skirt = *skirt;
  options.skirt_settings = proto.skirt_settings();
  options.objects_may_overlap = proto.objects_may_overlap();
  options.avoid_curled = proto.avoid_curled();
  options.bed = *std::move(bed);
  return options;
}

}  // namespace slicefarm
