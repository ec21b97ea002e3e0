#pragma once

#include <vector>

#include "common/config/table/bind.h"
#include "common/config/table/setting_spec.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config {

template <>
struct RowOf<MachineRow> : MemberRow<&FdmRows::machine, Scope::kJob> {};
template <>
struct RowOf<ObjectRow> : MemberRow<&FdmRows::object, Scope::kObject> {};
template <>
struct RowOf<RegionRow> : MemberRow<&FdmRows::region, Scope::kRegion> {};
template <>
struct RowOf<ToolRow> : MemberRow<&FdmRows::tool, Scope::kJob> {};

}  // namespace slicefarm::config

namespace slicefarm::config::fdm {

// Sections of the settings table, by topic.
std::vector<SettingSpec> SlicingSettings();  ///< defined in settings_slicing.cc
/// Polyholes and printable overhangs, a part of SlicingSettings; defined in settings_holes.cc.
std::vector<SettingSpec> HoleSettings();
/// Z contouring, a part of SlicingSettings; defined in settings_contour.cc.
std::vector<SettingSpec> ContourSettings();
std::vector<SettingSpec> WallSettings();  ///< defined in settings_walls.cc
/// Rough walls, a part of WallSettings; defined in settings_fuzzy.cc.
std::vector<SettingSpec> FuzzySkinSettings();
std::vector<SettingSpec> SeamSettings();    ///< defined in settings_seams.cc
std::vector<SettingSpec> InfillSettings();  ///< defined in settings_infill.cc
/// Skins and other solid infill, a part of InfillSettings; defined in settings_solid.cc.
std::vector<SettingSpec> SolidSettings();
/// Top and bottom surfaces and bridges, a part of InfillSettings; defined in settings_surfaces.cc.
std::vector<SettingSpec> SurfaceSettings();
/// Single infill patterns, a part of InfillSettings; defined in settings_patterns.cc.
std::vector<SettingSpec> PatternSettings();
/// Ironing of the part, a part of InfillSettings; defined in settings_ironing.cc.
std::vector<SettingSpec> IroningSettings();
std::vector<SettingSpec> AdhesionSettings();  ///< defined in settings_adhesion.cc
std::vector<SettingSpec> SupportSettings();   ///< defined in settings_supports.cc
/// Ironing of supports, a part of SupportSettings; defined in settings_ironing.cc.
std::vector<SettingSpec> SupportIroningSettings();
std::vector<SettingSpec> SpeedSettings();  ///< defined in settings_speed.cc
/// Accelerations and jerks, a part of SpeedSettings; defined in settings_dynamics.cc.
std::vector<SettingSpec> DynamicsSettings();
std::vector<SettingSpec> FlowSettings();      ///< defined in settings_flow.cc
std::vector<SettingSpec> FilamentSettings();  ///< defined in settings_filament.cc
/// Fans and pressure advance by kinds of lines, a part of FilamentSettings; defined in
/// settings_fans.cc.
std::vector<SettingSpec> FanSettings();
std::vector<SettingSpec> MachineSettings();  ///< defined in settings_machine.cc
/// Checks by the printer and the camera, a part of MachineSettings; defined in
/// settings_monitoring.cc.
std::vector<SettingSpec> MonitoringSettings();
std::vector<SettingSpec> TravelSettings();   ///< defined in settings_travel.cc
std::vector<SettingSpec> WritingSettings();  ///< defined in settings_writing.cc

}  // namespace slicefarm::config::fdm
