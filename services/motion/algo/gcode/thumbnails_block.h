#pragma once

#include <string>
#include <vector>

#include "common/model/scene/mesh.h"

namespace slicefarm::motion {

/// The pictures as comments, as printer hosts read them:
///   ; thumbnail begin 32x32 1234      pixels; characters of base64
///   ; iVBORw0KGgo...                  at most 78 a line
///   ; thumbnail end
/// Source: PrusaSlicer's thumbnails; Moonraker takes one only if the count of characters is right.
std::string ThumbnailsBlock(const std::vector<Thumbnail>& thumbnails);

}  // namespace slicefarm::motion
