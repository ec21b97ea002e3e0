#pragma once

#include <memory>
#include <utility>

#include "common/model/process.h"

namespace slicefarm {

/// Holder of a value of one process's type, such as FdmSettings. Code that stores or copies the
/// holder does not need the type. Copies share the value until one of them is changed. An empty
/// ProcessValue has the default value of the default process.
class ProcessValue {
 public:
  ProcessValue() = default;
  /// Stores a value of a type with kProcess and operator==. The constructor is implicit, so that
  /// the settings of a process can be assigned directly.
  template <typename T>
  requires requires { T::kProcess; }
  ProcessValue(T value)  // NOLINT(google-explicit-constructor)
      : process_(T::kProcess), held_(std::make_shared<Held<T>>(std::move(value))) {}

  Process process() const { return process_; }

  /// Returns the value. REQUIRES: the ProcessValue was made from a T, or it is empty and T belongs
  /// to the default process.
  template <typename T>
  const T& As() const {
    static const T kStandard;
    return held_ == nullptr ? kStandard : static_cast<const Held<T>&>(*held_).value;
  }
  template <typename T>
  T& As() {
    if (held_ == nullptr || held_.use_count() > 1)
      held_ = std::make_shared<Held<T>>(std::as_const(*this).template As<T>());
    return static_cast<Held<T>&>(*held_).value;
  }

  friend bool operator==(const ProcessValue& a, const ProcessValue& b) {
    if (a.process_ != b.process_ || a.held_ == b.held_) return a.process_ == b.process_;
    return a.held_ != nullptr ? a.held_->Equals(b.held_.get()) : b.held_->Equals(nullptr);
  }

 private:
  struct Holder {
    virtual ~Holder() = default;
    /// Returns true if both values are equal. `other`: a holder of the same type; null: the default
    /// value.
    virtual bool Equals(const Holder* other) const = 0;
  };
  template <typename T>
  struct Held : Holder {
    explicit Held(T held) : value(std::move(held)) {}
    bool Equals(const Holder* other) const override {
      return other == nullptr ? value == T() : value == static_cast<const Held&>(*other).value;
    }
    T value;
  };

  Process process_ = kDefaultProcess;
  std::shared_ptr<Holder> held_;
};

}  // namespace slicefarm
