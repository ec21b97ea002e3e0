#pragma once

#include <unistd.h>

#include <utility>

namespace slicefarm::slicing {

/// Owner of a file descriptor. The destructor closes it.
class Fd {
 public:
  Fd() = default;
  explicit Fd(int number) : number_(number) {}
  Fd(Fd&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Fd& operator=(Fd&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Fd() {
    if (number_ >= 0) close(number_);
  }

  /// Returns the descriptor; -1 if there is none.
  int number() const { return number_; }

 private:
  int number_ = -1;
};

}  // namespace slicefarm::slicing
