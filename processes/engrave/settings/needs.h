#pragma once

#include "common/config/table/need.h"
#include "common/model/options/settings.h"
#include "processes/engrave/model/engrave_settings.h"

namespace slicefarm::config::engrave::needs {

inline bool IsProgram(const JobRows& s) { return EngraveOf(s).format == EngraveFormat::kGcode; }
inline bool IsMesh(const JobRows& s) {
  const EngraveFormat format = EngraveOf(s).format;
  return format == EngraveFormat::kStl || format == EngraveFormat::kObj;
}
inline bool HasImage(const JobRows& s) { return !EngraveOf(s).texture.image.empty(); }

inline constexpr Need kImage{"a texture_image", HasImage};
inline constexpr Need kNoImage{"no texture_image, which replaces it",
                               [](const JobRows& s) { return !HasImage(s); }};
inline constexpr Need kProgram{"output_format = gcode", IsProgram};
inline constexpr Need kMesh{"output_format = stl or obj", IsMesh};

}  // namespace slicefarm::config::engrave::needs
