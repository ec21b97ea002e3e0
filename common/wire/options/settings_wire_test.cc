#include "common/wire/options/settings_wire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/wire/support/every_field.h"
#include "google/protobuf/text_format.h"
#include "google/protobuf/util/message_differencer.h"

namespace slicefarm::settings_wire_test {
namespace {

using google::protobuf::Message;
using google::protobuf::TextFormat;
using google::protobuf::util::MessageDifferencer;

v1::FdmSettings Proto(const FdmSettings& settings) {
  v1::FdmSettings proto;
  EXPECT_TRUE(ToProto(settings, &proto).ok());
  return proto;
}

// The bindings name every member: a new one does not compile until it is sent here, and so on the
// wire.
RaftHeights DistinctRaft() {
  RaftHeights heights;
  auto& [layers, first, others, contact_distance] = heights;
  layers = 2;
  first = 602;
  others = 603;
  contact_distance = 604;
  return heights;
}

SkirtOptions DistinctSkirt() {
  SkirtOptions options;
  auto& [loops, distance, min_length, height_layers, draft_shield, width, height, filament_area] =
      options;
  loops = 11;
  distance = 612;
  min_length = 5'000'000'000;
  height_layers = 14;
  draft_shield = DraftShield::kLimited;
  width = 616;
  height = 617;
  filament_area = 6.18;
  return options;
}

BrimOptions DistinctBrim() {
  BrimOptions options;
  auto& [type, automatic, width, separation, line_width, ear_max_angle, ear_detection] = options;
  type = BrimType::kEars;
  automatic = {true, 627, 628, 629};
  width = 622;
  separation = 623;
  line_width = 624;
  ear_max_angle = 1.25;
  ear_detection = 626;
  return options;
}

RaftOptions DistinctRaftOptions() {
  RaftOptions options;
  auto& [heights, lines, expansion, first_layer_expansion] = options;
  heights = DistinctRaft();
  auto& [width, spacing, angle, first_layer_density] = lines;
  width = 634;
  spacing = 635;
  angle = 0.636;
  first_layer_density = 0.637;
  expansion = 632;
  first_layer_expansion = 633;
  return options;
}

SupportOptions DistinctSupport() {
  SupportOptions options;
  auto& [on, automatic, style, threshold, enforced_layers, bed_only, skip_bridges, top_gap,
         bottom_gap, xy_gap, closingius, top_interface_layers, bottom_interface_layers, spacing,
         interface_spacing, pattern, interface_pattern, angle, sheath, width, wall_width, walls,
         layer_height, first_layer_height, min_layer_height, synchronize_layers, tree] = options;
  on = true;
  automatic = true;
  style = SupportStyle::kTree;
  threshold = 0.654;
  enforced_layers = 655;
  bed_only = true;
  skip_bridges = true;
  top_gap = 658;
  bottom_gap = 659;
  xy_gap = 660;
  closingius = 661;
  top_interface_layers = 662;
  bottom_interface_layers = 663;
  spacing = 664;
  interface_spacing = 665;
  pattern = SupportPattern::kHoneycomb;
  interface_pattern = InterfacePattern::kConcentric;
  angle = 0.668;
  sheath = true;
  width = 670;
  wall_width = 671;
  walls = 677;
  layer_height = 672;
  first_layer_height = 673;
  min_layer_height = 674;
  synchronize_layers = true;
  tree = {0.691, 0.692, 693, 0.694, 695, 696, 697, 0.698};
  return options;
}

InfillPlanOptions DistinctInfillPlan() {
  InfillPlanOptions options;
  auto& [pattern, choose_pattern, goal, density, angle, width, walls, top_layers, bottom_layers,
         top_spare, bottom_spare, interface_shells, every_layers, only_where_needed] = options;
  pattern = FillPattern::kSupportCubic;
  choose_pattern = true;
  goal = FillGoal::kFlexibility;
  density = 0.125;
  angle = -0.25;
  width = 150;
  walls = 151;
  top_layers = 152;
  bottom_layers = 153;
  top_spare = {155, 156};
  bottom_spare = {157, 158};
  interface_shells = true;
  every_layers = 154;
  only_where_needed = true;
  return options;
}

PlanningOptions DistinctPlanning() {
  PlanningOptions options;
  auto& [objects, sequence, skirt, skirt_settings, infill, may_overlap, avoid_curled, bed] =
      options;
  infill = {DistinctInfillPlan()};
  auto& [complete_objects, clearance_radius, clearance_height] = sequence;
  complete_objects = true;
  clearance_radius = 151;
  clearance_height = 152;
  ObjectPlanOptions object;
  auto& [seam, brim, brim_settings, raft, raft_settings, support, support_settings, spiral] =
      object;
  seam = SeamPosition::kRear;
  brim = DistinctBrim();
  brim_settings = 641;
  raft = DistinctRaftOptions();
  raft_settings = {642, 643};
  support = DistinctSupport();
  support_settings = {681, 682, 683, 684, 685};
  spiral = {686, false};
  objects = {object, {SeamPosition::kNearest}};
  skirt = DistinctSkirt();
  skirt_settings = 644;
  may_overlap = avoid_curled = true;
  bed = {{{{0, 1}, {2, 3}, {4, 2'000'000'000}}, {}}};
  return options;
}

BeadingOptions DistinctBeading() {
  BeadingOptions options;
  auto& [generator, perimeters, one_on_bed, one_on_top, extra, fuzzy, fuzzy_thickness,
         fuzzy_distance, external_width, inner_width, first_layer_width, gap_fill, min_gap_width,
         max_gap_width, thin_walls, least_tip, transition_length, transition_angle, transition_deviation,
         distribution_count, min_feature, min_bead_width, max_bead_width, lock_outer_width,
         wall_class] = options;
  generator = WallGenerator::kClassic;
  perimeters = 201;
  one_on_bed = true;
  one_on_top = OneWallOnTop::kSurfaces;
  extra = true;
  fuzzy = FuzzySkin::kAllWalls;
  fuzzy_thickness = 218;
  fuzzy_distance = 219;
  external_width = 202;
  inner_width = 203;
  first_layer_width = 204;
  gap_fill = false;
  min_gap_width = 206;
  max_gap_width = 207;
  thin_walls = false;
  least_tip = 220;
  transition_length = 209;
  transition_angle = 0.21;
  transition_deviation = 211;
  distribution_count = 212;
  min_feature = 213;
  min_bead_width = 214;
  max_bead_width = 215;
  lock_outer_width = true;
  wall_class = 217;
  return options;
}

InfillOptions DistinctInfill() {
  InfillOptions options;
  auto& [top_layers, bottom_layers, top_spare, bottom_spare, density, pattern, choose_pattern, goal,
         solid_pattern, top_pattern, bottom_pattern, angle, angle_template, solid_angle_template,
         sparse_width, solid_width, top_width, first_layer_width, overlap, solid_below_area, anchor,
         anchor_max, smoothing, solid_every_layers, bridge_angle, bridge_flow, thick_bridges, walls,
         over_bridges, interface_shells, nozzle, every_layers, only_where_needed, shells,
         overhang_lines, ironing, small_area_flow, small_area_flow_table, density_field,
         stress_field, field_halo_layers] = options;
  top_spare = {325, 326};
  bottom_spare = {327, 328};
  choose_pattern = true;
  goal = FillGoal::kTime;
  angle_template = "0,45";
  solid_angle_template = "+30";
  bridge_flow = 0.9;
  thick_bridges = false;
  over_bridges = true;
  interface_shells = true;
  small_area_flow = true;
  small_area_flow_table = "0,0.5;3.24,1";
  nozzle = 323;
  walls = 324;
  every_layers = 321;
  only_where_needed = true;
  shells = ShellThickness::kPartial;
  overhang_lines = true;
  auto& [iron, iron_type, iron_flow, iron_spacing] = ironing;
  iron = true;
  iron_type = IroningType::kTopmost;
  iron_flow = 0.2;
  iron_spacing = 322;
  top_layers = 301;
  bottom_layers = 302;
  density = 0.303;
  pattern = FillPattern::kGyroid;
  solid_pattern = FillPattern::kConcentric;
  top_pattern = FillPattern::kMonotonic;
  bottom_pattern = FillPattern::kHilbert;
  angle = -0.308;
  sparse_width = 309;
  solid_width = 310;
  top_width = 311;
  first_layer_width = 312;
  overlap = -313;
  solid_below_area = 314.5;
  anchor = 315;
  anchor_max = 316;
  smoothing = 317;
  solid_every_layers = 318;
  density_field = "density";
  stress_field = "stress";
  field_halo_layers = 320;
  bridge_angle = 0.319;
  return options;
}

OrderingOptions DistinctOrdering() {
  OrderingOptions options;
  auto& [infill_first, clockwise, travel, improvement_moves, walls] = options;
  infill_first = true;
  clockwise = true;
  auto& [hide, longest_hidden, avoid_crossing, max_detour, max_detour_ratio, layer_change,
         travel_room] = travel;
  hide = false;
  longest_hidden = 401;
  avoid_crossing = true;
  max_detour = 402;
  max_detour_ratio = 4.03;
  layer_change = true;
  travel_room = {{{{1, 2}, {4, 2}, {1, 5}}, {}}};
  improvement_moves = 404;
  WallOrder order;
  auto& [external_first, inner_outer_inner, towards_holes, stagger, whole_loops] = order;
  external_first = true;
  inner_outer_inner = false;
  towards_holes = true;
  stagger = whole_loops = true;
  walls = {order, {false, true}};
  return options;
}

MachineLimits DistinctLimits() {
  MachineLimits limits;
  auto& [feedrate, acceleration, jerk, extruding, retracting, travel, junction_deviation,
         square_corner_velocity, minimum_cruise_ratio, min_extruding_rate, min_travel_rate,
         jerk_limit, emit] = limits;
  feedrate = {1, 2, 3, 4};
  acceleration = {5, 6, 7, 8};
  jerk = {9, 10, 11, 12};
  extruding = 13;
  retracting = 14;
  travel = 15;
  junction_deviation = 16;
  square_corner_velocity = 17;
  minimum_cruise_ratio = 18;
  min_extruding_rate = 19;
  min_travel_rate = 20;
  jerk_limit = 21;
  emit = true;
  return limits;
}

RetractionOptions DistinctRetraction() {
  RetractionOptions retraction;
  auto& [length, speed, restart_speed, restart_extra, min_travel, lift, lift_above, lift_below,
         lift_after, ramping, ramp_lift, ramp_slope, before_obstacles, wipe, before_wipe] = retraction;
  length = 21;
  speed = 22;
  restart_speed = 23;
  restart_extra = -24;
  min_travel = 25;
  lift = 26;
  lift_above = 27;
  lift_below = 28;
  lift_after = LiftAfter::kTop;
  ramping = true;
  ramp_lift = 30;
  ramp_slope = 31;
  before_obstacles = true;
  wipe = true;
  before_wipe = 0.29;
  return retraction;
}

CoolingOptions DistinctCooling() {
  CoolingOptions cooling;
  auto& [enabled, always_on, min_fan, max_fan, bridge_fan, disable_first, fan_below, slowdown_below,
         min_speed, consistent_surface, transition, full_fan_layer, dynamic_fan, overhang_fan] =
      cooling;
  enabled = false;
  always_on = true;
  min_fan = 33;
  max_fan = 34;
  bridge_fan = 35;
  disable_first = 36;
  fan_below = 37;
  slowdown_below = 38;
  min_speed = 39;
  consistent_surface = true;
  transition = 45;
  full_fan_layer = 40;
  dynamic_fan = true;
  overhang_fan = {41, 42, 43, 44};
  return cooling;
}

MotionOptions DistinctMotion() {
  MotionOptions options;
  auto& [flavor, limits, silent_limits, retraction, cooling, speeds, travel_speed,
         first_layer_travel_speed, travel_speed_z,
         first_layer_speed, first_layer_speed_ratio, first_layer_infill_speed, over_raft_speed,
         over_raft_speed_ratio, max_print_speed, max_volumetric_speed, flow_rise, flow_fall,
         pressure_advance, acceleration, default_acceleration, first_layer_acceleration,
         over_raft_acceleration, travel_acceleration, short_travel_acceleration, seam_gap,
         nozzle_diameter, filament_diameter, extrusion_multiplier, filament_density, filament_cost,
         filament_type, filament_colour, filament_settings_id, printer_model, temperature,
         first_layer_temperature, bed_temperature, first_layer_bed_temperature, chamber_temperature,
         chamber_least, heats_chamber, emit_temperatures, tool, nozzle_heating, bed_heating, progress, z_offset,
         extruder_offset, start_gcode, start_filament_gcode, end_gcode, before_layer_gcode, layer_gcode,
         layer_settings, labels, between_objects_gcode, max_print_height, room, arc_fitting, resolution,
         material_field, writing] = options;
  flavor = GcodeFlavor::kKlipper;
  limits = DistinctLimits();
  silent_limits = DistinctLimits();
  silent_limits->junction_deviation_mm = 116;
  retraction = DistinctRetraction();
  cooling = DistinctCooling();
  RegionSpeeds region;
  auto& [speed, small_perimeter_speed, dynamic_overhangs, overhang_speed, scarf, bridging_walls,
         region_bridge_flow, region_thick_bridges] = region;
  speed = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 507, 505, 508};
  small_perimeter_speed = 506;
  bridging_walls = true;
  region_bridge_flow = 0.8;
  region_thick_bridges = false;
  auto& [placement, only_on_smooth, on_inner, entire_loop, start_height, length, max_segment] =
      scarf;
  placement = ScarfPlacement::kContours;
  only_on_smooth = false;
  on_inner = true;
  entire_loop = true;
  start_height = 0.51;
  length = 5.2;
  max_segment = 5.3;
  dynamic_overhangs = true;
  overhang_speed = {541, 542, 543, 544};
  speeds = {region, {}};
  travel_speed = 507;
  first_layer_travel_speed = 563;
  travel_speed_z = 508;
  first_layer_speed = 509;
  first_layer_speed_ratio = 510;
  first_layer_infill_speed = 551;
  over_raft_speed = 552;
  over_raft_speed_ratio = 553;
  over_raft_acceleration = 554;
  flow_rise = 555;
  flow_fall = 556;
  pressure_advance = 557;
  nozzle_heating = 558;
  bed_heating = 559;
  max_print_speed = 511;
  max_volumetric_speed = 512;
  acceleration = {11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 508, 513, 518};
  default_acceleration = 514;
  first_layer_acceleration = 515;
  travel_acceleration = 516;
  short_travel_acceleration = 560;
  seam_gap = 0.561;
  nozzle_diameter = 517;
  filament_diameter = 518;
  extrusion_multiplier = 519;
  filament_density = 520;
  filament_cost = 521;
  filament_type = "type";
  filament_colour = "colour";
  filament_settings_id = "id";
  printer_model = "model";
  temperature = 526;
  first_layer_temperature = 527;
  bed_temperature = 528;
  first_layer_bed_temperature = 529;
  chamber_temperature = 530;
  chamber_least = 531;
  heats_chamber = true;
  emit_temperatures = false;
  tool = 4;
  progress = true;
  z_offset = -531;
  extruder_offset = {-561, 562};
  room = {{{{3, 2}, {6, 2}, {3, 5}}, {}}};
  start_gcode = "start";
  start_filament_gcode = "filament";
  end_gcode = "end";
  before_layer_gcode = "before";
  layer_gcode = "layer";
  layer_settings = "settings";
  labels = ObjectLabels::kFirmware;
  arc_fitting = ArcFitting::kEmitCenter;
  resolution = 539;
  between_objects_gcode = "between";
  max_print_height = 538;
  material_field = "materials";
  auto& [relative, volumetric, by_firmware, comments, binary, substitutions, file_name, height_code,
         color_change, pause, at_height] = writing;
  relative = false;
  volumetric = true;
  by_firmware = true;
  comments = true;
  binary = true;
  substitutions = "substitutions";
  file_name = "file";
  height_code = "heights";
  color_change = "color";
  pause = "pause";
  at_height = "template";
  return options;
}

FdmSettings Distinct() {
  FdmSettings settings;
  auto& [planning, beading, infill, ordering, motion] = settings;
  planning = DistinctPlanning();
  beading = {DistinctBeading(), {}};
  infill = {DistinctInfill(), {}};
  ordering = DistinctOrdering();
  motion = DistinctMotion();
  return settings;
}

constexpr char kDistinct[] = R"pb(
  planning {
    sequence { complete_objects: true clearance_radius_nm: 151 clearance_height_nm: 152 }
    objects {
      seam: SEAM_POSITION_REAR
      brim {
        type: BRIM_TYPE_EARS
        width_nm: 622
        separation_nm: 623
        line_width_nm: 624
        ear_max_angle_rad: 1.25
        ear_detection_nm: 626
        automatic { on: true thermal_length_mm: 627 adhesion: 628 max_speed_mm_s: 629 }
      }
      brim_settings: 641
      raft {
        heights { layers: 2 first_nm: 602 others_nm: 603 contact_distance_nm: 604 }
        lines { width_nm: 634 spacing_nm: 635 angle_rad: 0.636 first_layer_density: 0.637 }
        expansion_nm: 632
        first_layer_expansion_nm: 633
      }
      raft_settings: [ 642, 643 ]
      support {
        on: true
        automatic: true
        style: SUPPORT_STYLE_TREE
        threshold_rad: 0.654
        enforced_layers: 655
        bed_only: true
        skip_bridges: true
        top_gap_nm: 658
        bottom_gap_nm: 659
        xy_gap_nm: 660
        closing_radius_nm: 661
        top_interface_layers: 662
        bottom_interface_layers: 663
        spacing_nm: 664
        interface_spacing_nm: 665
        pattern: SUPPORT_PATTERN_HONEYCOMB
        interface_pattern: INTERFACE_PATTERN_CONCENTRIC
        angle_rad: 0.668
        sheath: true
        width_nm: 670
        wall_width_nm: 671
        walls_nm: 677
        layer_height_nm: 672
        first_layer_height_nm: 673
        min_layer_height_nm: 674
        synchronize_layers: true
        tree {
          angle_rad: 0.691
          slow_angle_rad: 0.692
          branch_diameter_nm: 693
          diameter_angle_rad: 0.694
          double_wall_diameter_nm: 695
          tip_diameter_nm: 696
          branch_distance_nm: 697
          top_rate: 0.698
        }
      }
      support_settings: [ 681, 682, 683, 684, 685 ]
      spiral { width_nm: 686 }
    }
    skirt {
      loops: 11
      distance_nm: 612
      min_length_nm: 5000000000
      height_layers: 14
      draft_shield: DRAFT_SHIELD_LIMITED
      width_nm: 616
      height_nm: 617
      filament_area_mm2: 6.18
    }
    skirt_settings: 644
    bed {
      xy_nm: [ 0, 1, 2, 3, 4, 2000000000 ]
      ring_sizes: 3
      rings_per_island: 1
    }
    objects_may_overlap: true
    avoid_curled: true
    infill {
      pattern: FILL_PATTERN_SUPPORT_CUBIC
      choose_pattern: true
      goal: FILL_GOAL_FLEXIBILITY
      density: 0.125
      angle_rad: -0.25
      width_nm: 150
      walls_nm: 151
      top_solid_layers: 152
      bottom_solid_layers: 153
      top_spare { layers: 155 enough_nm: 156 }
      bottom_spare { layers: 157 enough_nm: 158 }
      every_layers: 154
      only_where_needed: true
      interface_shells: true
    }
  }
  beading {
    perimeters: 201
    external_width_nm: 202
    inner_width_nm: 203
    first_layer_width_nm: 204
    gap_fill: false
    min_gap_width_nm: 206
    max_gap_width_nm: 207
    generator: WALL_GENERATOR_CLASSIC
    thin_walls: false
    least_tip_nm: 220
    transition_length_nm: 209
    transition_angle: 0.21
    transition_deviation_nm: 211
    distribution_count: 212
    min_feature_nm: 213
    min_bead_width_nm: 214
    max_bead_width_nm: 215
    lock_outer_width: true
    wall_class: 217
    one_on_bed: true
    one_on_top: ONE_WALL_ON_TOP_SURFACES
    extra_perimeters: true
    fuzzy: FUZZY_SKIN_ALL_WALLS
    fuzzy_thickness_nm: 218
    fuzzy_point_distance_nm: 219
  }
  infill {
    top_solid_layers: 301
    bottom_solid_layers: 302
    top_spare { layers: 325 enough_nm: 326 }
    bottom_spare { layers: 327 enough_nm: 328 }
    density: 0.303
    pattern: FILL_PATTERN_GYROID
    solid_pattern: FILL_PATTERN_CONCENTRIC
    top_pattern: FILL_PATTERN_MONOTONIC
    bottom_pattern: FILL_PATTERN_HILBERT
    angle_rad: -0.308
    sparse_width_nm: 309
    solid_width_nm: 310
    top_width_nm: 311
    first_layer_width_nm: 312
    overlap_nm: -313
    solid_below_area_mm2: 314.5
    anchor_nm: 315
    anchor_max_nm: 316
    smoothing_nm: 317
    solid_every_layers: 318
    bridge_angle_rad: 0.319
    density_text: 1
    stress_text: 2
    field_halo_layers: 320
    choose_pattern: true
    goal: FILL_GOAL_TIME
    angle_text: 3
    solid_angle_text: 4
    bridge_flow: 0.9
    every_layers: 321
    only_where_needed: true
    shells: SHELL_THICKNESS_PARTIAL
    overhang_lines: true
    nozzle_nm: 323
    walls_nm: 324
    over_bridges: true
    interface_shells: true
    small_area_flow: true
    flow_text: 5
    ironing { enabled: true type: IRONING_TYPE_TOPMOST flow: 0.2 spacing_nm: 322 }
  }
  ordering {
    infill_first: true
    clockwise: true
    improvement_moves: 404
    travel {
      longest_hidden_mm: 401
      avoid_crossing: true
      max_detour_mm: 402
      max_detour_ratio: 4.03
      retract_layer_change: true
      room {
        xy_nm: [ 1, 2, 4, 2, 1, 5 ]
        ring_sizes: 3
        rings_per_island: 1
      }
    }
    walls { external_perimeters_first: true towards_holes: true stagger_seams: true whole_loops: true }
  }
  motion {
    flavor: GCODE_FLAVOR_KLIPPER
    limits {
      max_feedrate_mm_s: [ 1, 2, 3, 4 ]
      max_acceleration_mm_s2: [ 5, 6, 7, 8 ]
      max_jerk_mm_s: [ 9, 10, 11, 12 ]
      max_acceleration_extruding_mm_s2: 13
      max_acceleration_retracting_mm_s2: 14
      max_acceleration_travel_mm_s2: 15
      junction_deviation_mm: 16
      square_corner_velocity_mm_s: 17
      minimum_cruise_ratio: 18
      min_extruding_rate_mm_s: 19
      min_travel_rate_mm_s: 20
      jerk_mm_s3: 21
      emit_to_gcode: true
    }
    retraction {
      length_mm: 21
      speed_mm_s: 22
      restart_speed_mm_s: 23
      restart_extra_mm: -24
      min_travel_mm: 25
      lift_mm: 26
      lift_above_mm: 27
      lift_below_mm: 28
      ramping: true
      ramp_lift_mm: 30
      ramp_slope_deg: 31
      before_obstacles: true
      lift_after: LIFT_AFTER_TOP
      wipe: true
      before_wipe: 0.29
    }
    cooling {
      enabled: false
      fan_always_on: true
      min_fan_percent: 33
      max_fan_percent: 34
      bridge_fan_percent: 35
      disable_fan_first_layers: 36
      fan_below_layer_time_s: 37
      slowdown_below_layer_time_s: 38
      min_print_speed_mm_s: 39
      consistent_surface: true
      transition_mm: 45
      full_fan_speed_layer: 40
      dynamic_fan: true
      overhang_fan_percent: [ 41, 42, 43, 44 ]
    }
    speeds {
      speed_mm_s: [ 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 507, 505, 508 ]
      small_perimeter_speed_mm_s: 506
      scarf {
        placement: SCARF_PLACEMENT_CONTOURS
        on_inner: true
        entire_loop: true
        start_height_ratio: 0.51
        length_mm: 5.2
        max_segment_mm: 5.3
      }
      dynamic_overhangs: true
      overhang_speed_mm_s: [ 541, 542, 543, 544 ]
      bridging_walls: true
      bridge_flow: 0.8
    }
    travel_speed_mm_s: 507
    travel_speed_z_mm_s: 508
    first_layer_speed_mm_s: 509
    first_layer_speed_ratio: 510
    first_layer_infill_speed_mm_s: 551
    over_raft_speed_mm_s: 552
    over_raft_speed_ratio: 553
    over_raft_acceleration_mm_s2: 554
    flow_rise_mm3_s2: 555
    flow_fall_mm3_s2: 556
    pressure_advance: 557
    nozzle_heating_c_s: 558
    bed_heating_c_s: 559
    max_print_speed_mm_s: 511
    max_volumetric_speed_mm3_s: 512
    acceleration_mm_s2: [ 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 508, 513, 518 ]
    default_acceleration_mm_s2: 514
    first_layer_acceleration_mm_s2: 515
    travel_acceleration_mm_s2: 516
    short_travel_acceleration_mm_s2: 560
    seam_gap_mm: 0.561
    nozzle_diameter_mm: 517
    filament_diameter_mm: 518
    extrusion_multiplier: 519
    filament_density_g_cm3: 520
    filament_cost_per_kg: 521
    filament_type: "type"
    filament_colour: "colour"
    filament_settings_id: "id"
    printer_model: "model"
    temperature_c: 526
    first_layer_temperature_c: 527
    bed_temperature_c: 528
    first_layer_bed_temperature_c: 529
    chamber_temperature_c: 530
    chamber_least_c: 531
    tool: 4
    progress: true
    z_offset_mm: -531
    heats_chamber: true
    first_layer_travel_speed_mm_s: 563
    extruder_offset { x_nm: -561 y_nm: 562 }
    room {
      xy_nm: [ 3, 2, 6, 2, 3, 5 ]
      ring_sizes: 3
      rings_per_island: 1
    }
    start_gcode: "start"
    start_filament_gcode: "filament"
    end_gcode: "end"
    before_layer_gcode: "before"
    layer_gcode: "layer"
    layer_settings: "settings"
    labels: OBJECT_LABELS_FIRMWARE
    between_objects_gcode: "between"
    max_print_height_nm: 538
    arc_fitting: ARC_FITTING_EMIT_CENTER
    resolution_nm: 539
    material_field: "materials"
    writing {
      volumetric_e: true
      firmware_retraction: true
      comments: true
      binary: true
      substitutions: "substitutions"
      file_name: "file"
      height_code: "heights"
      color_change_gcode: "color"
      pause_gcode: "pause"
      template_gcode: "template"
    }
    silent_limits {
      max_feedrate_mm_s: [ 1, 2, 3, 4 ]
      max_acceleration_mm_s2: [ 5, 6, 7, 8 ]
      max_jerk_mm_s: [ 9, 10, 11, 12 ]
      max_acceleration_extruding_mm_s2: 13
      max_acceleration_retracting_mm_s2: 14
      max_acceleration_travel_mm_s2: 15
      junction_deviation_mm: 116
      square_corner_velocity_mm_s: 17
      minimum_cruise_ratio: 18
      min_extruding_rate_mm_s: 19
      min_travel_rate_mm_s: 20
      jerk_mm_s3: 21
      emit_to_gcode: true
    }
  }
  texts: [ "density", "stress", "0,45", "+30", "0,0.5;3.24,1" ]
)pb";

/// The first row of each table; what is in the others needs no text of its own.
v1::FdmSettings WithoutLastRows(v1::FdmSettings proto) {
  proto.mutable_planning()->mutable_objects()->RemoveLast();
  proto.mutable_beading()->RemoveLast();
  proto.mutable_infill()->RemoveLast();
  proto.mutable_texts()->RemoveLast();  // the standard flow table
  proto.mutable_ordering()->mutable_walls()->RemoveLast();
  proto.mutable_motion()->mutable_speeds()->RemoveLast();
  return proto;
}

// Sees fields that are swapped in both directions, which no round trip does.
TEST(SettingsWire, EachMemberIsTheFieldOfItsName) {
  v1::FdmSettings want;
  ASSERT_TRUE(TextFormat::ParseFromString(kDistinct, &want));
  MessageDifferencer differencer;
  std::string difference;
  differencer.ReportDifferencesToString(&difference);
  EXPECT_TRUE(differencer.Compare(want, WithoutLastRows(Proto(Distinct())))) << difference;
}

TEST(SettingsWire, DefaultsAndDistinctValuesReturn) {
  for (const FdmSettings& settings : {FdmSettings{}, Distinct()}) {
    const absl::StatusOr<FdmSettings> back = FromProto(Proto(settings));
    ASSERT_TRUE(back.ok()) << back.status();
    EXPECT_EQ(*back, settings);
  }
}

TEST(SettingsWire, EveryFieldChangedAloneReturns) {
  FdmSettings defaults;
  // The next value of 100 % would be refused.
  defaults.motion.cooling.max_fan_percent = 50;
  defaults.motion.cooling.bridge_fan_percent = 50;
  int fields = 0;
  ForEachChangedField(Proto(defaults), [&](const std::string& path, const Message& message) {
    SCOPED_TRACE(path);
    ++fields;
    const auto& changed = dynamic_cast<const v1::FdmSettings&>(message);
    const absl::StatusOr<FdmSettings> settings = FromProto(changed);
    if (path.find("flow_text") != std::string::npos) {  // there is one text
      EXPECT_EQ(DetailOf(settings.status()).metadata["field"], "infill[0].flow_text");
      return;
    }
    ASSERT_TRUE(settings.ok()) << settings.status();
    EXPECT_FALSE(*settings == defaults);
    EXPECT_TRUE(MessageDifferencer::Equals(Proto(*settings), changed));
  });
  EXPECT_GT(fields, 100);
}

// However many rows have it, there and back.
TEST(SettingsWire, ATextOfManyRowsTravelsOnce) {
  FdmSettings settings;
  settings.beading.resize(3);
  settings.infill.resize(3);
  settings.ordering.walls.resize(3);
  settings.motion.speeds.resize(3);
  for (InfillOptions& row : settings.infill) row.density_field = std::string(100'000, 'x');
  settings.infill[1].density_field = "y";
  const v1::FdmSettings proto = Proto(settings);
  EXPECT_LT(proto.ByteSizeLong(), 110'000u);
  const absl::StatusOr<FdmSettings> back = FromProto(proto);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(*back, settings);
  EXPECT_EQ(&back->infill[0].density_field.str(), &back->infill[2].density_field.str());
}

TEST(SettingsWire, RefusesTextsThatAreNotThere) {
  for (const int32_t number : {-1, 2}) {
    v1::FdmSettings proto = Proto({});
    ASSERT_EQ(proto.texts_size(), 1);
    proto.mutable_infill(0)->set_stress_text(number);
    const absl::Status status = FromProto(proto).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
    EXPECT_EQ(DetailOf(status).metadata["field"], "infill[0].stress_text");
  }
  v1::FdmSettings proto = Proto({});
  proto.set_texts(0, std::string(limits::kMaxFieldBytes + 1, 'x'));
  EXPECT_EQ(DetailOf(FromProto(proto).status()).reason, Reason::kRequestTooLarge);
}

// Objects and regions are counted apart; tables of regions are not.
TEST(SettingsWire, TablesOfRegionsAreEquallyLong) {
  const auto expect_refused = [](const v1::FdmSettings& proto) {
    const absl::Status status = FromProto(proto).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed) << status;
    EXPECT_EQ(DetailOf(status).metadata["field"], "settings") << status;
  };
  FdmSettings beading, infill, walls, speeds;
  beading.beading.resize(2);
  infill.infill.resize(2);
  walls.ordering.walls.resize(2);
  speeds.motion.speeds.resize(2);
  for (const FdmSettings& settings : {beading, infill, walls, speeds})
    expect_refused(Proto(settings));
  FdmSettings objects;
  objects.planning.objects.resize(3);
  EXPECT_TRUE(FromProto(Proto(objects)).ok());
}

TEST(SettingsWire, RefusesTablesOfMoreRowsThanAJobMayHave) {
  const std::vector<std::function<void(FdmSettings&)>> spoils = {
      [](auto& s) { s.planning.objects.resize(1'001); },
      [](auto& s) { s.beading.resize(1'001); },
      [](auto& s) { s.ordering.walls.resize(1'001); },
      [](auto& s) { s.motion.speeds.resize(1'001); },
  };
  for (const auto& spoil : spoils) {
    FdmSettings settings;
    spoil(settings);
    const absl::Status status = FromProto(Proto(settings)).status();
    EXPECT_EQ(DetailOf(status).reason, Reason::kRequestTooLarge) << status;
    EXPECT_EQ(DetailOf(status).metadata["limit"], "1000");
  }
}

}  // namespace
}  // namespace slicefarm::settings_wire_test
