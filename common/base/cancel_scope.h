#pragma once

#include "common/base/cancel_token.h"

namespace slicefarm {

/// As long as it lives, what its thread waits for is not wanted any more once the token says so:
/// for those who wait deep below and are handed no token, as stores are. Scopes of a thread nest;
/// the innermost one counts.
class CancelScope {
 public:
  explicit CancelScope(CancelToken token);
  ~CancelScope();
  CancelScope(const CancelScope&) = delete;
  CancelScope& operator=(const CancelScope&) = delete;

  /// Of this thread; without a scope, never cancelled.
  static CancelToken Current();

 private:
  const CancelToken token_;
  const CancelScope* const outer_;
};

}  // namespace slicefarm
