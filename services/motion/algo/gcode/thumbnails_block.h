#pragma once

#include <string>
#include <vector>

#include "common/model/scene/mesh.h"

namespace slicefarm::motion {

/// Returns the pictures as comments, as printer hosts read them:
///   ; thumbnail begin 32x32 1234      width x height in pixels; number of base64 characters
///   ; iVBORw0KGgo...                  at most 78 characters per line
///   ; thumbnail end
/// Source: PrusaSlicer's thumbnails. Moonraker accepts a picture only if the number of characters
/// is right.
std::string ThumbnailsBlock(const std::vector<Thumbnail>& thumbnails);

}  // namespace slicefarm::motion
