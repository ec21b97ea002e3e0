#pragma once

#include <string>


namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// One kind's style in words without commas: "hatch 200 W 800 mm/s".
std::string StyleText(const ExposureOptions& options, size_t kind);

}  // namespace slicefarm::exposure
