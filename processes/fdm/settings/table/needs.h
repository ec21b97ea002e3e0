#pragma once

#include "common/config/setting_values.h"
#include "common/config/table/need.h"
#include "common/model/options/planning_options.h"
#include "common/model/options/support_options.h"
#include "common/model/options/tool_row.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::fdm::needs {

// Requirements of settings for FDM.

inline bool HasSupports(const JobRows& s) { return FdmOf(s).object.support.on; }

inline bool Combines(const SettingValues& draft) {
  return draft.Number("automatic_infill_combination") != 0;
}

inline constexpr Need kRetractLength{"retract_length above 0", [](const JobRows& s) {
                                       return FdmOf(s).tool.retraction.length_mm > 0;
                                     }};
inline constexpr Need kStraightLift{
    "travel_ramping_lift = 0", [](const JobRows& s) { return !FdmOf(s).tool.retraction.ramping; }};
inline constexpr Need kRampingLift{
    "travel_ramping_lift = 1", [](const JobRows& s) { return FdmOf(s).tool.retraction.ramping; }};
inline constexpr Need kOwnRetraction{
    "use_firmware_retraction = 0, because the firmware sets this length itself",
    [](const JobRows& s) { return !FdmOf(s).machine.motion.writing.firmware_retraction; }};
inline constexpr Need kAdaptiveLayers{"adaptive_layer_height = 1",
                                      [](const JobRows& s) { return s.object.adaptive.on; }};
inline constexpr Need kNoHeightProfile{
    "no layer_height_profile, which replaces it", [](const JobRows& s) {
      const ObjectSlicingOptions& object = s.object;
      return !object.adaptive.on || object.height_profile.empty();
    }};
inline constexpr Need kLayerByLayer{"complete_objects = 0", [](const JobRows& s) {
                                      return !FdmOf(s).machine.plan.sequence.complete_objects;
                                    }};
inline constexpr Need kAnyLift{
    "retract_lift above 0 or, with travel_ramping_lift = 1, travel_max_lift above 0",
    [](const JobRows& s) {
      const RetractionOptions& retraction = FdmOf(s).tool.retraction;
      return (retraction.ramping ? retraction.ramp_lift_mm : retraction.lift_mm) > 0;
    }};
inline constexpr Need kTravelAcceleration{
    "travel_acceleration above 0",
    [](const JobRows& s) { return FdmOf(s).machine.motion.travel_acceleration_mm_s2 > 0; }};
inline constexpr Need kConsistentSurface{
    "cooling_slowdown_logic = consistent_surface",
    [](const JobRows& s) { return FdmOf(s).tool.cooling.consistent_surface; }};
inline constexpr Need kFuzzySkin{"a fuzzy_skin other than none", [](const JobRows& s) {
                                   return FdmOf(s).region.walls.fuzzy != FuzzySkin::kNone;
                                 }};
inline constexpr Need kWipe{"wipe = 1",
                            [](const JobRows& s) { return FdmOf(s).tool.retraction.wipe; }};
inline constexpr Need kOwnWipeSpeed{"role_based_wipe_speed = 0", [](const JobRows& s) {
                                      return !FdmOf(s).machine.motion.wipe_as_printed;
                                    }};
inline constexpr Need kDefaultAcceleration{
    "default_acceleration above 0",
    [](const JobRows& s) { return FdmOf(s).machine.motion.default_acceleration_mm_s2 > 0; }};
inline constexpr Need kKlipper{"gcode_flavor = klipper", [](const JobRows& s) {
                                 return FdmOf(s).machine.motion.flavor == GcodeFlavor::kKlipper;
                               }};
inline constexpr Need kMarlin{"a gcode_flavor of Marlin", [](const JobRows& s) {
                                return FdmOf(s).machine.motion.flavor != GcodeFlavor::kKlipper;
                              }};
inline constexpr Need kCooling{"cooling = 1",
                               [](const JobRows& s) { return FdmOf(s).tool.cooling.enabled; }};
inline constexpr Need kFlowFit{
    .what = "volumetric_speed_coefficients",
    .met_by =
        [](const SettingValues& draft) {
          return !draft.At("volumetric_speed_coefficients").value->text.empty();
        },
    .only_requested = true};
inline constexpr Need kAdaptiveFlow{
    .what = "filament_adaptive_volumetric_speed = 1",
    .met_by =
        [](const SettingValues& draft) {
          return draft.Number("filament_adaptive_volumetric_speed") != 0;
        },
    .only_requested = true};
inline constexpr Need kWrappingDetection{
    .what = "enable_wrapping_detection = 1",
    .met_by =
        [](const SettingValues& draft) { return draft.Number("enable_wrapping_detection") != 0; },
    .only_requested = true};
inline constexpr Need kWrappingArea{
    .what = "wrapping_exclude_area",
    .met_by =
        [](const SettingValues& draft) {
          return !draft.At("wrapping_exclude_area").value->text.empty();
        },
    .only_requested = true};
inline constexpr Need kForceY{"machine_max_force_y above 0", [](const JobRows& s) {
                                return FdmOf(s).machine.motion.bed_motor.force_n > 0;
                              }};
inline constexpr Need kTraditionalTimelapse{
    .what = "timelapse_type = 0",
    .met_by = [](const SettingValues& draft) { return draft.Number("timelapse_type") == 0; },
    .only_requested = true};
inline constexpr Need kSkirt{
    "skirts above 0", [](const JobRows& s) { return FdmOf(s).machine.plan.skirt.loops > 0; }};
inline constexpr Need kGivenBrimWidth{"a brim_type other than auto_brim", [](const JobRows& s) {
                                        return !FdmOf(s).object.brim.automatic.on;
                                      }};
inline constexpr Need kBrim{"a brim_type other than no_brim, and no raft", [](const JobRows& s) {
                              const ObjectPlanOptions& object = FdmOf(s).object;
                              return object.brim.type != BrimType::kNone &&
                                     object.raft.heights.layers == 0;
                            }};
inline constexpr Need kBrimEars{"brim_type = brim_ears", [](const JobRows& s) {
                                  return FdmOf(s).object.brim.type == BrimType::kEars;
                                }};
inline constexpr Need kAvoidCrossing{"avoid_crossing_perimeters = 1", [](const JobRows& s) {
                                       return FdmOf(s).machine.order.travel.avoid_crossing;
                                     }};
inline constexpr Need kHiddenTravels{
    "only_retract_when_crossing_perimeters = 1",
    [](const JobRows& s) { return FdmOf(s).machine.order.travel.hide; }};
inline constexpr Need kRaft{"raft_layers above 0", [](const JobRows& s) {
                              return FdmOf(s).object.raft.heights.layers > 0;
                            }};
inline constexpr Need kRaftOrTree{
    "raft_layers above 0, or support_material = 1 with support_material_style = organic",
    [](const JobRows& s) {
      const ObjectPlanOptions& object = FdmOf(s).object;
      return object.raft.heights.layers > 0 ||
             (object.support.on && object.support.style == SupportStyle::kTree);
    }};
inline constexpr Need kRaftOrSupports{"raft_layers above 0 or support_material = 1",
                                      [](const JobRows& s) {
                                        const ObjectPlanOptions& object = FdmOf(s).object;
                                        return object.raft.heights.layers > 0 || object.support.on;
                                      }};
inline constexpr Need kSupports{"support_material = 1", HasSupports};
inline constexpr Need kSupportsIfRequested{
    .what = "support_material = 1", .met = HasSupports, .only_requested = true};
inline constexpr Need kTreeSupports{"support_material = 1 and support_material_style = organic",
                                    [](const JobRows& s) {
                                      const SupportOptions& support = FdmOf(s).object.support;
                                      return support.on && support.style == SupportStyle::kTree;
                                    }};
inline constexpr Need kFan{"cooling = 1 or fan_always_on = 1", [](const JobRows& s) {
                             return FdmOf(s).tool.cooling.enabled ||
                                    FdmOf(s).tool.cooling.fan_always_on;
                           }};
inline constexpr Need kObjectByObject{"complete_objects = 1", [](const JobRows& s) {
                                        return FdmOf(s).machine.plan.sequence.complete_objects;
                                      }};
inline constexpr Need kIroning{
    "ironing = 1", [](const JobRows& s) { return FdmOf(s).region.infill.ironing.enabled; }};
inline constexpr Need kStraightIroning{"ironing_pattern = rectilinear", [](const JobRows& s) {
                                         return !FdmOf(s).region.infill.ironing.concentric;
                                       }};
inline constexpr Need kSupportInterfaces{
    "support_material = 1 and support_material_interface_layers above 0", [](const JobRows& s) {
      const SupportOptions& support = FdmOf(s).object.support;
      return support.on && support.top_interface_layers > 0;
    }};
inline constexpr Need kSupportIroning{"support_material = 1 and support_ironing = 1",
                                      [](const JobRows& s) {
                                        const SupportOptions& support = FdmOf(s).object.support;
                                        return support.on && support.ironing.enabled;
                                      }};
inline constexpr Need kAnyIroning{"ironing = 1 or support_ironing = 1", [](const JobRows& s) {
                                    return FdmOf(s).region.infill.ironing.enabled ||
                                           FdmOf(s).object.support.ironing.enabled;
                                  }};
inline constexpr Need kContour{"zaa_enabled = 1",
                               [](const JobRows& s) { return s.object.contour.on; }};
inline constexpr Need kSmallAreaFlow{
    "small_area_infill_flow_compensation = 1",
    [](const JobRows& s) { return FdmOf(s).region.infill.small_area_flow; }};
inline constexpr Need kMedialAxis{"fill_pattern = medialaxis", [](const JobRows& s) {
                                    return !FdmOf(s).region.infill.choose_pattern &&
                                           FdmOf(s).region.infill.pattern ==
                                               FillPattern::kMedialAxis;
                                  }};
inline constexpr Need kAutoPattern{
    "fill_pattern = auto", [](const JobRows& s) { return FdmOf(s).region.infill.choose_pattern; }};
inline constexpr Need kNoDensityField{"no density_field, which replaces it", [](const JobRows& s) {
                                        return FdmOf(s).region.infill.density_field.empty();
                                      }};
inline constexpr Need kNoStressField{"no stress_field, which replaces it", [](const JobRows& s) {
                                       return FdmOf(s).region.infill.stress_field.empty();
                                     }};
inline constexpr Need kCombinedByHeight{"automatic_infill_combination = 1", nullptr, Combines};
inline constexpr Need kCombinedByNumber{
    "automatic_infill_combination = 0", nullptr,
    [](const SettingValues& draft) { return !Combines(draft); }};

inline constexpr Need kDefaultJerk{"default_jerk above 0", [](const JobRows& s) {
                                     return FdmOf(s).machine.motion.jerk.default_mm_s > 0;
                                   }};
inline constexpr Need kJunctionDeviation{
    "gcode_flavor = marlin2 and machine_max_junction_deviation above 0", [](const JobRows& s) {
      const MachineMotion& motion = FdmOf(s).machine.motion;
      const bool marlin2 =
          motion.flavor == GcodeFlavor::kMarlin2 || motion.flavor == GcodeFlavor::kPrusaBuddy;
      return marlin2 && motion.limits.junction_deviation_mm > 0;
    }};
inline constexpr Need kMarlinOrJerk{
    "a gcode_flavor of Marlin, or default_jerk above 0", [](const JobRows& s) {
      const MachineMotion& motion = FdmOf(s).machine.motion;
      return motion.flavor != GcodeFlavor::kKlipper || motion.jerk.default_mm_s > 0;
    }};
inline constexpr Need kDynamicOverhangs{"enable_dynamic_overhang_speeds = 1", [](const JobRows& s) {
                                          return FdmOf(s).region.motion.dynamic_overhangs;
                                        }};
inline constexpr Need kFlowSlope{
    "max_volumetric_extrusion_rate_slope_positive or _negative above 0", [](const JobRows& s) {
      const MachineMotion& motion = FdmOf(s).machine.motion;
      return motion.flow_rise_mm3_s2 > 0 || motion.flow_fall_mm3_s2 > 0;
    }};
inline constexpr Need kOverhangReverse{
    .what = "overhang_reverse = 1",
    .met = [](const JobRows& s) { return FdmOf(s).region.motion.reversal.on; },
    .only_requested = true};
inline constexpr Need kFanSpeedup{"fan_speedup_time above 0", [](const JobRows& s) {
                                    return FdmOf(s).machine.motion.fan_speedup_s > 0;
                                  }};
inline constexpr Need kElephantFoot{"elefant_foot_compensation above 0",
                                    [](const JobRows& s) { return s.object.elephant_foot_nm > 0; }};
inline constexpr Need kTopExpansion{
    .what = "top_surface_expansion above 0",
    .met = [](const JobRows& s) { return FdmOf(s).region.infill.surfaces.expansion_nm > 0; },
    .only_requested = true};
inline constexpr Need kBridgeAngle{
    "bridge_angle or internal_bridge_angle above 0", [](const JobRows& s) {
      const InfillOptions& infill = FdmOf(s).region.infill;
      return infill.bridge_angle_rad > 0 || infill.bridges.internal_angle_rad > 0;
    }};
inline constexpr Need kScarfSeam{"a scarf_seam_placement other than nowhere", [](const JobRows& s) {
                                   return FdmOf(s).region.motion.scarf.placement !=
                                          ScarfPlacement::kNowhere;
                                 }};
inline constexpr Need kInnerWallsFirst{
    "external_perimeters_first = 0 and inner_outer_inner = 0", [](const JobRows& s) {
      const WallOrder& order = FdmOf(s).region.order;
      return !order.external_perimeters_first && !order.inner_outer_inner;
    }};
inline constexpr Need kOneWallOnTop{.what = "top_one_perimeter_type = top",
                                    .met =
                                        [](const JobRows& s) {
                                          return FdmOf(s).region.walls.one_on_top ==
                                                 OneWallOnTop::kSurfaces;
                                        },
                                    .only_requested = true};
inline constexpr Need kArachne{"perimeter_generator = arachne", [](const JobRows& s) {
                                 return FdmOf(s).region.walls.generator == WallGenerator::kArachne;
                               }};
inline constexpr Need kGapFill{"gap_fill_enabled = 1",
                               [](const JobRows& s) { return FdmOf(s).region.walls.gap_fill; }};
inline constexpr Need kColumnSupports{
    "support_material = 1 and a support_material_style of columns", [](const JobRows& s) {
      const SupportOptions& support = FdmOf(s).object.support;
      return support.on && support.style != SupportStyle::kTree;
    }};
inline constexpr Need kSkippedBridges{"dont_support_bridges = 1", [](const JobRows& s) {
                                        return FdmOf(s).object.support.skip_bridges;
                                      }};
inline constexpr Need kNoThreshold{"support_material_threshold = 0", [](const JobRows& s) {
                                     return FdmOf(s).object.support.threshold_rad <= 0;
                                   }};

inline constexpr Need kSpiral{.what = "spiral_vase = 1",
                              .met = [](const JobRows& s) { return s.object.hollow_from > 0; },
                              .only_requested = true};
inline constexpr Need kAdaptiveAdvance{
    .what = "adaptive_pressure_advance = 1",
    .met = [](const JobRows& s) { return FdmOf(s).tool.advance.on; },
    .only_requested = true};
inline constexpr Need kResonance{
    .what = "resonance_avoidance = 1",
    .met = [](const JobRows& s) { return FdmOf(s).machine.motion.resonance.avoid; },
    .only_requested = true};

}  // namespace slicefarm::config::fdm::needs
