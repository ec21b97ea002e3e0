#pragma once

#include "common/base/cancel_token.h"

namespace slicefarm {

/// Scope that sets the current cancel token of its thread. Functions that wait and get no token as
/// an argument, such as the functions of stores, use it to stop waiting. Scopes of a thread nest;
/// the innermost one counts.
class CancelScope {
 public:
  explicit CancelScope(CancelToken token);
  ~CancelScope();
  CancelScope(const CancelScope&) = delete;
  CancelScope& operator=(const CancelScope&) = delete;

  /// Returns the current token of this thread. Without a scope, the token is never cancelled.
  static CancelToken Current();

 private:
  const CancelToken token_;
  const CancelScope* const outer_;
};

}  // namespace slicefarm
