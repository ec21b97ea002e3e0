#pragma once

#include <string_view>
#include <vector>

#include "common/model/options/cutter.h"
#include "common/model/options/cutter_text.h"

namespace slicefarm {

/// One cutter of each kind, about 4 mm wide.
inline const std::vector<std::string_view> kAllCutters = {
    "cyl:4",     "ball:4",    "bull:4:1",        "bull:4:0.1",          "cone:4:45",
    "cone:4:15", "cone:4:75", "ballcone:2:20:4", "bullcone:2:0.5:30:4", "conecone:2:60:20:4"};

inline Cutter CutterOf(std::string_view text) { return *ParseCutter(text); }

}  // namespace slicefarm
