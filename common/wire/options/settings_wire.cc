#include "common/wire/options/settings_wire.h"

#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/geometry_wire.h"
#include "common/wire/options/infill_options_wire.h"
#include "common/wire/options/motion_options_wire.h"
#include "common/wire/options/planning_options_wire.h"
#include "common/wire/options/settings_check.h"
#include "common/wire/support/enum_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"
#include "slicefarm/v1/process.pb.h"

namespace slicefarm {
namespace {

static_assert(v1::FILL_RULE_NON_ZERO == static_cast<int>(FillRule::kNonZero) + 1);
static_assert(v1::FILL_RULE_EVEN_ODD == static_cast<int>(FillRule::kEvenOdd) + 1);
static_assert(v1::FILL_RULE_POSITIVE == static_cast<int>(FillRule::kPositive) + 1);
static_assert(v1::WALL_GENERATOR_ARACHNE == static_cast<int>(WallGenerator::kArachne) + 1);
static_assert(v1::WALL_GENERATOR_CLASSIC == static_cast<int>(WallGenerator::kClassic) + 1);
static_assert(v1::ONE_WALL_ON_TOP_NOWHERE == static_cast<int>(OneWallOnTop::kNowhere) + 1);
static_assert(v1::ONE_WALL_ON_TOP_TOPMOST == static_cast<int>(OneWallOnTop::kTopmost) + 1);
static_assert(v1::ONE_WALL_ON_TOP_SURFACES == static_cast<int>(OneWallOnTop::kSurfaces) + 1);
static_assert(v1::FUZZY_SKIN_NONE == static_cast<int>(FuzzySkin::kNone) + 1);
static_assert(v1::FUZZY_SKIN_CONTOURS == static_cast<int>(FuzzySkin::kContours) + 1);
static_assert(v1::FUZZY_SKIN_ALL_WALLS == static_cast<int>(FuzzySkin::kAllWalls) + 1);
static_assert(v1::Process_MAX == kProcessCount);

constexpr double kMaxTransitionAngle = 1.6;  // radians: a right angle

absl::Status CheckThumbnails(const v1::SlicingOptions& proto) {
  if (proto.thumbnails_size() > limits::kMaxThumbnails) {
    return LimitError(Reason::kRequestTooLarge, "thumbnails", limits::kMaxThumbnails,
                      proto.thumbnails_size());
  }
  for (const v1::ThumbnailSize& size : proto.thumbnails()) {
    for (const int32_t px : {size.width_px(), size.height_px()}) {
      if (px < 1 || px > limits::kMaxThumbnailPx) return Malformed("thumbnails", "out of range");
    }
  }
  return absl::OkStatus();
}

absl::Status Check(const v1::AdaptiveHeights& proto) {
  absl::Status status = CheckComplete(proto);
  status.Update(CheckPositive({{"cusp_nm", proto.cusp_nm()}, {"min_nm", proto.min_nm()}}));
  if (proto.max_nm() < proto.min_nm() || proto.max_nm() > limits::kMaxCoord)
    status.Update(Malformed("max_nm", "is out of range"));
  if (!(proto.max_ratio() >= 1 && proto.max_ratio() <= kMostHeightRatio))
    status.Update(Malformed("max_ratio", "is out of range"));
  return status;
}

absl::StatusOr<std::vector<LayerHeightAt>> ProfileFromProto(const v1::ObjectSlicingOptions& proto) {
  constexpr const char* kField = "height_profile_nm";
  const auto& numbers = proto.height_profile_nm();
  if (numbers.size() % 2 != 0) return Malformed(kField, "has a z without a height");
  if (numbers.size() / 2 > kMaxLayerHeightPoints)
    return LimitError(Reason::kRequestTooLarge, "layer heights of an object",
                      kMaxLayerHeightPoints, numbers.size() / 2);
  std::vector<LayerHeightAt> profile;
  for (int i = 0; i < numbers.size(); i += 2) {
    const Coord z = numbers[i], height = numbers[i + 1], least = profile.empty() ? 0 : profile.back().z_nm;
    if (z < least || z > limits::kMaxCoord || height <= 0 || height > limits::kMaxCoord)
      return Malformed(kField, "is no list of heights by z, upwards");
    profile.push_back({z, height});
  }
  return profile;
}

absl::Status Check(const v1::ObjectSlicingOptions& proto) {
  absl::Status status = CheckComplete(proto);
  status.Update(CheckPositive({{"layer_height_nm", proto.layer_height_nm()}}));
  status.Update(
      CheckNotNegative({{"closing_radius_nm", proto.closing_radius_nm()},
                        {"lift_nm", proto.lift_nm()},
                        {"elephant_foot_min_width_nm", proto.elephant_foot_min_width_nm()}}));
  status.Update(CheckLengths({{"xy_compensation_nm", proto.xy_compensation_nm()},
                              {"hole_compensation_nm", proto.hole_compensation_nm()},
                              {"elephant_foot_nm", proto.elephant_foot_nm()}},
                             -limits::kMaxCoord));
  return status;
}

absl::Status Check(const v1::SlicingOptions& proto) {
  absl::Status status = CheckComplete(proto);
  status.Update(CheckPositive({{"first_layer_height_nm", proto.first_layer_height_nm()}}));
  status.Update(CheckNotNegative({{"max_gap_nm", proto.max_gap_nm()},
                                  {"resolution_nm", proto.resolution_nm()},
                                  {"max_print_height_nm", proto.max_print_height_nm()},
                                  {"part_distance_nm", proto.part_distance_nm()},
                                  {"clearance_radius_nm", proto.clearance_radius_nm()}}));
  status.Update(CheckRows(proto.objects_size(), "objects"));
  if (proto.bed_xy_nm_size() > 0 && proto.bed_xy_nm_size() < 6)
    status.Update(Malformed("bed_xy_nm", "fewer than 3 points"));
  status.Update(CheckThumbnails(proto));
  return status;
}

absl::Status Check(const v1::BeadingOptions& proto) {
  absl::Status status = CheckComplete(proto);
  if (proto.perimeters() < 0 || proto.perimeters() > limits::kMaxPerimeters) {
    status.Update(Malformed("perimeters", "is out of range"));
  }
  status.Update(CheckPositive({{"external_width_nm", proto.external_width_nm()},
                               {"inner_width_nm", proto.inner_width_nm()},
                               {"first_layer_width_nm", proto.first_layer_width_nm()},
                               {"fuzzy_point_distance_nm", proto.fuzzy_point_distance_nm()}}));
  status.Update(CheckNotNegative({{"fuzzy_thickness_nm", proto.fuzzy_thickness_nm()},
                                  {"min_gap_width_nm", proto.min_gap_width_nm()},
                                  {"max_gap_width_nm", proto.max_gap_width_nm()},
                                  {"transition_length_nm", proto.transition_length_nm()},
                                  {"transition_deviation_nm", proto.transition_deviation_nm()},
                                  {"min_feature_nm", proto.min_feature_nm()},
                                  {"min_bead_width_nm", proto.min_bead_width_nm()},
                                  {"max_bead_width_nm", proto.max_bead_width_nm()}}));
  if (!(proto.transition_angle() > 0 && proto.transition_angle() < kMaxTransitionAngle)) {
    status.Update(Malformed("transition_angle", "is out of range"));
  }
  if (proto.distribution_count() < 1 || proto.distribution_count() > limits::kMaxPerimeters) {
    status.Update(Malformed("distribution_count", "is out of range"));
  }
  return status;
}

v1::ObjectSlicingOptions ToProto(const ObjectSlicingOptions& options) {
  v1::ObjectSlicingOptions proto;
  proto.set_layer_height_nm(options.layer_height_nm);
  proto.set_fill_rule(EnumToProto<v1::FillRule>(options.fill_rule));
  proto.set_close_holes(options.close_holes);
  proto.set_closing_radius_nm(options.closing_radius_nm);
  proto.set_xy_compensation_nm(options.xy_compensation_nm);
  proto.set_hole_compensation_nm(options.hole_compensation_nm);
  proto.set_elephant_foot_nm(options.elephant_foot_nm);
  proto.set_elephant_foot_min_width_nm(options.elephant_foot_min_width_nm);
  proto.set_on_bed(options.on_bed);
  proto.set_lift_nm(options.lift_nm);
  v1::AdaptiveHeights& adaptive = *proto.mutable_adaptive();
  adaptive.set_on(options.adaptive.on);
  adaptive.set_cusp_nm(options.adaptive.cusp_nm);
  adaptive.set_min_nm(options.adaptive.min_nm);
  adaptive.set_max_nm(options.adaptive.max_nm);
  adaptive.set_max_ratio(options.adaptive.max_ratio);
  proto.set_hollow_from(options.hollow_from);
  proto.set_counterbores(EnumToProto<v1::CounterboreBridging>(options.counterbores));
  for (const LayerHeightAt& at : options.height_profile) {
    proto.add_height_profile_nm(at.z_nm);
    proto.add_height_profile_nm(at.height_nm);
  }
  return proto;
}

absl::StatusOr<ObjectSlicingOptions> ObjectFromProto(const v1::ObjectSlicingOptions& proto) {
  if (absl::Status status = Check(proto); !status.ok()) return status;
  ObjectSlicingOptions options;
  options.layer_height_nm = proto.layer_height_nm();
  options.fill_rule = Known<FillRule>(proto.fill_rule());
  options.close_holes = proto.close_holes();
  options.closing_radius_nm = proto.closing_radius_nm();
  options.xy_compensation_nm = proto.xy_compensation_nm();
  options.hole_compensation_nm = proto.hole_compensation_nm();
  options.elephant_foot_nm = proto.elephant_foot_nm();
  options.elephant_foot_min_width_nm = proto.elephant_foot_min_width_nm();
  options.on_bed = proto.on_bed();
  options.lift_nm = proto.lift_nm();
  if (absl::Status status = Check(proto.adaptive()); !status.ok()) return Within("adaptive", status);
  options.adaptive = {.on = proto.adaptive().on(),
                      .cusp_nm = proto.adaptive().cusp_nm(),
                      .min_nm = proto.adaptive().min_nm(),
                      .max_nm = proto.adaptive().max_nm(),
                      .max_ratio = proto.adaptive().max_ratio()};
  options.hollow_from = proto.hollow_from();
  if (options.hollow_from < 0 || options.hollow_from > limits::kMaxLayers)
    return Malformed("hollow_from", "is not the index of a layer");
  options.counterbores = Known<CounterboreBridging>(proto.counterbores());
  auto profile = ProfileFromProto(proto);
  if (!profile.ok()) return profile.status();
  options.height_profile = *std::move(profile);
  return options;
}

}  // namespace

absl::Status CheckRows(int rows, std::string_view field) {
  if (rows < 1) return Malformed(field, "are missing");
  if (rows <= limits::kMaxRegionSettings) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "rows of settings", limits::kMaxRegionSettings, rows);
}

absl::Status ToProto(const SlicingOptions& options, v1::SlicingOptions* proto) {
  proto->set_first_layer_height_nm(options.first_layer_height_nm);
  proto->set_max_gap_nm(options.max_gap_nm);
  proto->set_resolution_nm(options.resolution_nm);
  proto->set_max_print_height_nm(options.max_print_height_nm);
  proto->set_part_distance_nm(options.part_distance_nm);
  proto->set_clearance_radius_nm(options.clearance_radius_nm);
  for (const auto& [width, height, format] : options.thumbnails) {
    v1::ThumbnailSize* size = proto->add_thumbnails();
    size->set_width_px(width);
    size->set_height_px(height);
    size->set_format(EnumToProto<v1::PictureFormat>(format));
  }
  for (const ObjectSlicingOptions& object : options.objects)
    *proto->add_objects() = ToProto(object);
  MultiPolygon excluded;
  for (const Polygon& area : options.excluded) excluded.push_back({area, {}});
  absl::Status status = ToProto(excluded, proto->mutable_excluded());
  if (!status.ok()) return Within("excluded", status);
  status = PackPoints(options.bed, proto->mutable_bed_xy_nm());
  return status.ok() ? status : Within("bed_xy_nm", status);
}

absl::StatusOr<SlicingOptions> FromProto(const v1::SlicingOptions& proto) {
  if (absl::Status status = Check(proto); !status.ok()) return status;
  absl::StatusOr<Polygon> bed = UnpackPoints(proto.bed_xy_nm(), "bed_xy_nm");
  if (!bed.ok()) return bed.status();
  absl::StatusOr<MultiPolygon> excluded = FromProto(proto.excluded());
  if (!excluded.ok()) return Within("excluded", excluded.status());
  SlicingOptions options;
  for (PolygonWithHoles& area : *excluded) options.excluded.push_back(std::move(area.outer));
  options.first_layer_height_nm = proto.first_layer_height_nm();
  options.max_gap_nm = proto.max_gap_nm();
  options.resolution_nm = proto.resolution_nm();
  options.bed = *std::move(bed);
  options.max_print_height_nm = proto.max_print_height_nm();
  options.part_distance_nm = proto.part_distance_nm();
  options.clearance_radius_nm = proto.clearance_radius_nm();
  options.thumbnails.clear();
  for (const v1::ThumbnailSize& size : proto.thumbnails()) {
    options.thumbnails.push_back(
        {size.width_px(), size.height_px(), Known<PictureFormat>(size.format())});
  }
  options.objects.clear();
  for (int i = 0; i < proto.objects_size(); ++i) {
    const auto object = ObjectFromProto(proto.objects(i));
    if (!object.ok()) return Within("objects", i, object.status());
    options.objects.push_back(*object);
  }
  return options;
}

v1::BeadingOptions ToProto(const BeadingOptions& options) {
  v1::BeadingOptions proto;
  proto.set_perimeters(options.perimeters);
  proto.set_one_on_bed(options.one_on_bed);
  proto.set_one_on_top(EnumToProto<v1::OneWallOnTop>(options.one_on_top));
  proto.set_extra_perimeters(options.extra_perimeters);
  proto.set_fuzzy(EnumToProto<v1::FuzzySkin>(options.fuzzy));
  proto.set_fuzzy_thickness_nm(options.fuzzy_thickness_nm);
  proto.set_fuzzy_point_distance_nm(options.fuzzy_point_distance_nm);
  proto.set_external_width_nm(options.external_width_nm);
  proto.set_inner_width_nm(options.inner_width_nm);
  proto.set_first_layer_width_nm(options.first_layer_width_nm);
  proto.set_gap_fill(options.gap_fill);
  proto.set_min_gap_width_nm(options.min_gap_width_nm);
  proto.set_max_gap_width_nm(options.max_gap_width_nm);
  proto.set_generator(EnumToProto<v1::WallGenerator>(options.generator));
  proto.set_thin_walls(options.thin_walls);
  proto.set_least_tip_nm(options.least_tip_nm);
  proto.set_transition_length_nm(options.transition_length_nm);
  proto.set_transition_angle(options.transition_angle);
  proto.set_transition_deviation_nm(options.transition_deviation_nm);
  proto.set_distribution_count(options.distribution_count);
  proto.set_min_feature_nm(options.min_feature_nm);
  proto.set_min_bead_width_nm(options.min_bead_width_nm);
  proto.set_max_bead_width_nm(options.max_bead_width_nm);
  proto.set_lock_outer_width(options.lock_outer_width);
  proto.set_wall_class(options.wall_class);
  return proto;
}

absl::StatusOr<BeadingOptions> FromProto(const v1::BeadingOptions& proto) {
  if (absl::Status status = Check(proto); !status.ok()) return status;
  BeadingOptions options;
  options.perimeters = proto.perimeters();
  options.one_on_bed = proto.one_on_bed();
  options.one_on_top = Known<OneWallOnTop>(proto.one_on_top());
  options.extra_perimeters = proto.extra_perimeters();
  options.fuzzy = Known<FuzzySkin>(proto.fuzzy());
  options.fuzzy_thickness_nm = proto.fuzzy_thickness_nm();
  options.fuzzy_point_distance_nm = proto.fuzzy_point_distance_nm();
  options.external_width_nm = proto.external_width_nm();
  options.inner_width_nm = proto.inner_width_nm();
  options.first_layer_width_nm = proto.first_layer_width_nm();
  options.gap_fill = proto.gap_fill();
  options.min_gap_width_nm = proto.min_gap_width_nm();
  options.max_gap_width_nm = proto.max_gap_width_nm();
  options.generator = Known<WallGenerator>(proto.generator());
  options.thin_walls = proto.thin_walls();
  options.least_tip_nm = proto.least_tip_nm();
  options.transition_length_nm = proto.transition_length_nm();
  options.transition_angle = proto.transition_angle();
  options.transition_deviation_nm = proto.transition_deviation_nm();
  options.distribution_count = proto.distribution_count();
  options.min_feature_nm = proto.min_feature_nm();
  options.min_bead_width_nm = proto.min_bead_width_nm();
  options.max_bead_width_nm = proto.max_bead_width_nm();
  options.lock_outer_width = proto.lock_outer_width();
  options.wall_class = proto.wall_class();
  return options;
}

absl::Status ToProto(const OrderingOptions& options, v1::OrderingOptions* proto) {
  proto->set_infill_first(options.infill_first);
  proto->set_clockwise(options.clockwise);
  proto->set_improvement_moves(options.improvement_moves);
  const TravelOptions& travel = options.travel;
  v1::TravelOptions& of_travel = *proto->mutable_travel();
  of_travel.set_hide(travel.hide);
  of_travel.set_longest_hidden_mm(travel.longest_hidden_mm);
  of_travel.set_avoid_crossing(travel.avoid_crossing);
  of_travel.set_max_detour_mm(travel.max_detour_mm);
  of_travel.set_max_detour_ratio(travel.max_detour_ratio);
  of_travel.set_retract_layer_change(travel.retract_layer_change);
  for (const WallOrder& order : options.walls) {
    v1::WallOrder* walls = proto->add_walls();
    walls->set_external_perimeters_first(order.external_perimeters_first);
    walls->set_inner_outer_inner(order.inner_outer_inner);
    walls->set_towards_holes(order.towards_holes);
    walls->set_stagger_seams(order.stagger_seams);
    walls->set_whole_loops(order.whole_loops);
  }
  const absl::Status status = ToProto(travel.room, of_travel.mutable_room());
  return status.ok() ? status : Within("room", status);
}

absl::StatusOr<OrderingOptions> FromProto(const v1::OrderingOptions& proto) {
  absl::Status status = CheckComplete(proto);
  status.Update(CheckRows(proto.walls_size(), "walls"));
  if (!status.ok()) return status;
  if (proto.improvement_moves() < 0) return Malformed("improvement_moves", "is negative");
  for (const double length : {proto.travel().longest_hidden_mm(), proto.travel().max_detour_mm(),
                              proto.travel().max_detour_ratio()}) {
    if (!(length >= 0)) return Malformed("travel", "a length is negative");
  }
  OrderingOptions options;
  options.infill_first = proto.infill_first();
  options.clockwise = proto.clockwise();
  options.improvement_moves = proto.improvement_moves();
  const v1::TravelOptions& travel = proto.travel();
  absl::StatusOr<MultiPolygon> room = FromProto(travel.room());
  if (!room.ok()) return Within("room", room.status());
  options.travel = {travel.hide(),           travel.longest_hidden_mm(),
                    travel.avoid_crossing(), travel.max_detour_mm(),
                    travel.max_detour_ratio(), travel.retract_layer_change(),
                    *std::move(room)};
  options.walls.clear();
  for (const v1::WallOrder& walls : proto.walls())
    options.walls.push_back({walls.external_perimeters_first(), walls.inner_outer_inner(),
                             walls.towards_holes(), walls.stagger_seams(), walls.whole_loops()});
  return options;
}

absl::Status ToProto(const FdmSettings& settings, v1::FdmSettings* proto) {
  for (const BeadingOptions& row : settings.beading) *proto->add_beading() = ToProto(row);
  ToProto(settings.infill, proto->mutable_infill(), proto->mutable_texts());
  absl::Status status = ToProto(settings.ordering, proto->mutable_ordering());
  if (!status.ok()) return Within("ordering", status);
  status = ToProto(settings.motion, proto->mutable_motion());
  if (!status.ok()) return Within("motion", status);
  status = ToProto(settings.planning, proto->mutable_planning());
  return status.ok() ? status : Within("planning", status);
}

absl::StatusOr<FdmSettings> FromProto(const v1::FdmSettings& proto) {
  absl::StatusOr<PlanningOptions> planning = FromProto(proto.planning());
  if (!planning.ok()) return Within("planning", planning.status());
  absl::StatusOr<OrderingOptions> ordering = FromProto(proto.ordering());
  if (!ordering.ok()) return Within("ordering", ordering.status());
  absl::StatusOr<MotionOptions> motion = FromProto(proto.motion());
  if (!motion.ok()) return Within("motion", motion.status());
  FdmSettings settings{*std::move(planning), {}, {}, *std::move(ordering), *std::move(motion)};
  absl::Status status = CheckRows(proto.beading_size(), "beading");
  status.Update(AllFromProto(proto.beading(), "beading", &settings.beading));
  if (!status.ok()) return status;
  auto infill = FromProto(proto.infill(), proto.texts(), "infill");
  if (!infill.ok()) return infill.status();
  settings.infill = *std::move(infill);
  const size_t rows = settings.beading.size();
  if (settings.infill.size() != rows || settings.ordering.walls.size() != rows ||
      settings.motion.speeds.size() != rows)
    return Malformed("settings", "the tables of regions are not equally long");
  return settings;
}

}  // namespace slicefarm
