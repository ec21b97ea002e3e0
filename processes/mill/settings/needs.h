#pragma once

#include "common/config/table/need.h"
#include "common/model/options/settings.h"
#include "processes/mill/model/milling_options.h"

namespace slicefarm::config::mill::needs {

inline bool Finishes(const JobRows& s) { return MillOf(s).how.finishing; }
inline bool IsProgram(const JobRows& s) { return MillOf(s).format == MillFormat::kGcode; }

inline constexpr Need kFinishing{"finishing = 1", Finishes};
inline constexpr Need kHelix{"entry = helix", [](const JobRows& s) {
                               return MillOf(s).how.machining.entry == EntryKind::kHelix;
                             }};
inline constexpr Need kSlopedEntry{"entry = helix or ramp", [](const JobRows& s) {
                                     return MillOf(s).how.machining.entry != EntryKind::kPlunge;
                                   }};
inline constexpr Need kBoxStock{"no stock (the stock is a box)",
                                [](const JobRows& s) { return MillOf(s).stock.empty(); }};
inline constexpr Need kDrawing{"output_format = svg",
                               [](const JobRows& s) { return !IsProgram(s); }};
inline constexpr Need kProgram{"output_format = gcode", IsProgram};

}  // namespace slicefarm::config::mill::needs
