#pragma once

#include <string_view>

namespace slicefarm {

/// Returns the version, such as `0.1.0`.
std::string_view Version();

/// Returns the day of the release, such as `2026-11-21`. It is a constant in the source, so that
/// outputs that contain a date are reproducible.
std::string_view ReleaseDate();

/// Returns the build id: 16 hex digits of a digest over all data that determine a job's result:
/// sources of the stages, compiler and libraries (cmake/build_info.cmake). Equal sources and tools
/// give the same id, with or without a repository. Builds with the same id give the same bytes and
/// understand each other's messages.
std::string_view BuildId();

}  // namespace slicefarm
