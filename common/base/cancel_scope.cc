#include "common/base/cancel_scope.h"

#include <utility>

namespace slicefarm {
namespace {

thread_local const CancelScope* innermost = nullptr;

}  // namespace

CancelScope::CancelScope(CancelToken token)
    : token_(std::move(token)), outer_(std::exchange(innermost, this)) {}

CancelScope::~CancelScope() { innermost = outer_; }

CancelToken CancelScope::Current() {
  return innermost == nullptr ? CancelToken() : innermost->token_;
}

}  // namespace slicefarm
