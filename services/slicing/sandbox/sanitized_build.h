#pragma once

namespace slicefarm::slicing {

/// True if this build is instrumented by the address or the thread sanitizer. The sanitizers'
/// runtimes reserve terabytes of address space, make additional system calls, read options from the
/// environment and report on stderr. Without a sanitizer, the confinement of a mesh reader
/// (confinement.h) denies all of this.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitizedBuild = true;
#elif defined(__has_feature)
inline constexpr bool kSanitizedBuild =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool kSanitizedBuild = false;
#endif

}  // namespace slicefarm::slicing
