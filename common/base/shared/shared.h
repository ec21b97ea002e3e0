#pragma once

#include <any>
#include <map>
#include <memory>
#include <mutex>
#include <type_traits>
#include <typeindex>
#include <utility>

namespace slicefarm {

/// Value that many tasks share, such as a job's settings. The value never changes. Copies of this
/// object are cheap references to the same value. Results that are derived from the value are
/// computed once (Once). Thread-safe.
template <typename T>
class Shared {
 public:
  Shared() : Shared(T{}) {}
  Shared(T value)  // NOLINT(google-explicit-constructor): a value may be handed on as a shared one
      : held_(std::make_shared<const Held>(std::move(value))) {}

  const T& operator*() const { return held_->value; }
  const T* operator->() const { return &held_->value; }

  /// Returns the result of `make(const T&)`. The first call computes the result; later calls, also
  /// on copies of this object, return the same result. Results are distinguished only by their
  /// type: two functions `make` with the same result type share one result. The result exists as
  /// long as the value. `make` must not call Once of the same value.
  template <typename Make, typename Made = std::invoke_result_t<const Make&, const T&>>
  const Made& Once(const Make& make) const {
    const std::lock_guard lock(held_->mutex);
    std::any& made = held_->made[typeid(Made)];
    if (!made.has_value()) made = std::make_shared<const Made>(make(held_->value));
    return **std::any_cast<std::shared_ptr<const Made>>(&made);
  }

 private:
  struct Held {
    explicit Held(T given) : value(std::move(given)) {}
    const T value;
    mutable std::mutex mutex;
    mutable std::map<std::type_index, std::any> made;
  };

  std::shared_ptr<const Held> held_;  // by all copies
};

}  // namespace slicefarm
