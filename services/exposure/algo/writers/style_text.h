#pragma once

#include <string>

#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

/// One kind's style in words without commas: "hatch 200 W 800 mm/s".
std::string StyleText(const ExposureOptions& options, size_t kind);

}  // namespace slicefarm::exposure
