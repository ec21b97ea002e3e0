#pragma once

namespace slicefarm::slicing {

/// True if this build is instrumented by the address or the thread sanitizer. The runtimes of the
/// sanitizers reserve terabytes of address space, make additional system calls, take options from
/// the environment and report on stderr. All of this is otherwise denied to a mesh reader.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitizedBuild = true;
#elif defined(__has_feature)
inline constexpr bool kSanitizedBuild =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool kSanitizedBuild = false;
#endif

}  // namespace slicefarm::slicing
