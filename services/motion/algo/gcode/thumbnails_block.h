#pragma once

#include <string>
#include <vector>

#include "common/model/scene/mesh.h"

namespace slicefarm::motion {

/// Returns the pictures as comments, as printer hosts read them:
///   ; thumbnail begin 32x32 1234      pixels; characters of base64
///   ; iVBORw0KGgo...                  at most 78 per line
///   ; thumbnail end
/// Source: PrusaSlicer's thumbnails. Moonraker accepts a picture only if the count of characters is
/// right.
std::string ThumbnailsBlock(const std::vector<Thumbnail>& thumbnails);

}  // namespace slicefarm::motion
