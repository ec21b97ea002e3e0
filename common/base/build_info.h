#pragma once

#include <string_view>

namespace slicefarm {

/// `0.1.0`
std::string_view Version();

/// Day of the release, `2026-11-21`: a constant of the source, so that programs quote a date and
/// stay reproducible.
std::string_view ReleaseDate();

/// 16 hex digits of a digest over the product's source files (cmake/build_info.cmake): the same
/// wherever the same source was built, with or without a repository around it. Builds with the same
/// id give the same bytes.
std::string_view BuildId();

}  // namespace slicefarm
