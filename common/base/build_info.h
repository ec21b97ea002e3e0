#pragma once

#include <string_view>

namespace slicefarm {

/// `0.1.0`
std::string_view Version();

/// Day of the release, `2026-11-21`: a constant of the source, so that programs quote a date and
/// stay reproducible.
std::string_view ReleaseDate();

/// 16 hex digits of a digest over what decides a job's result: the sources of the stages, compiler
/// and libraries (cmake/build_info.cmake). The same wherever the same source was built by the same
/// tools, with or without a repository around it. Builds with the same id give the same bytes, and
/// understand each other.
std::string_view BuildId();

}  // namespace slicefarm
