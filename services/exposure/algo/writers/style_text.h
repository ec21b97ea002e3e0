#pragma once

#include <string>

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Returns the style of one kind of vector in words without commas: "hatch 200 W 800 mm/s".
std::string StyleText(const ExposureOptions& options, size_t kind);

}  // namespace slicefarm::exposure
