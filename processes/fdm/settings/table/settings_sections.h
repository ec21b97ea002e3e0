#pragma once

#include <vector>

#include "common/config/table/setting_spec.h"

namespace slicefarm::config::fdm {

/// What the settings of filament printing may set.
template <class Job>
struct View {
  explicit View(Job& job)
      : slicing(job.slicing),
        planning(FdmOf(job).planning),
        beading(FdmOf(job).beading),
        infill(FdmOf(job).infill),
        ordering(FdmOf(job).ordering),
        motion(FdmOf(job).motion) {}

  Like<SlicingOptions, Job>& slicing;
  Like<PlanningOptions, Job>& planning;
  Like<std::vector<BeadingOptions>, Job>& beading;
  Like<std::vector<InfillOptions>, Job>& infill;
  Like<OrderingOptions, Job>& ordering;
  Like<MotionOptions, Job>& motion;
};

///     Bind([](auto& s) -> auto& { return s.infill[0].density; })
template <Scale kScale = Scale::kSame, class Member>
Field Bind(Member member) {
  return BindTo<View, kScale>(member);
}

// The parts of the settings table, by what they are about.
std::vector<SettingSpec> SlicingSettings();   ///< settings_slicing.cc
std::vector<SettingSpec> WallSettings();      ///< settings_walls.cc
std::vector<SettingSpec> SeamSettings();      ///< settings_seams.cc
std::vector<SettingSpec> InfillSettings();    ///< settings_infill.cc
std::vector<SettingSpec> AdhesionSettings();  ///< settings_adhesion.cc
std::vector<SettingSpec> SupportSettings();   ///< settings_supports.cc
std::vector<SettingSpec> SpeedSettings();     ///< settings_speed.cc
std::vector<SettingSpec> FilamentSettings();  ///< settings_filament.cc
std::vector<SettingSpec> MachineSettings();   ///< settings_machine.cc
std::vector<SettingSpec> WritingSettings();   ///< settings_writing.cc

}  // namespace slicefarm::config::fdm
