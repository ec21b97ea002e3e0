#pragma once

#include "common/base/cancel_token.h"

namespace slicefarm {

/// Scope that sets the current cancel token of its thread. Functions that wait but have no token as
/// an argument, such as the functions of stores, stop waiting when this token is cancelled. The
/// scopes of a thread can be nested; the innermost scope applies.
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
