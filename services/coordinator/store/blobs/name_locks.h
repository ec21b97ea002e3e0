#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace slicefarm::coordinator {

/// One lock per name. A lock that is held for long does not block other names. Thread-safe; must
/// outlive its held locks.
class NameLocks {
 public:
  /// Held lock. The destructor releases it.
  class Held {
   public:
    Held(Held&& other) noexcept
        : locks_(std::exchange(other.locks_, nullptr)), name_(std::move(other.name_)) {}
    Held& operator=(Held&&) = delete;
    ~Held() {
      if (locks_ != nullptr) locks_->LetGo(name_);
    }

   private:
    friend class NameLocks;
    Held(NameLocks* locks, std::string name) : locks_(locks), name_(std::move(name)) {}

    NameLocks* locks_;
    std::string name_;
  };

  /// Takes the lock. Waits while another thread holds it.
  Held Take(const std::string& name) {
    std::unique_lock lock(mutex_);
    let_go_.wait(lock, [&] { return held_.insert(name).second; });
    return Held(this, name);
  }

  /// Takes the lock; returns nullopt if another thread holds it.
  std::optional<Held> TryTake(const std::string& name) {
    const std::lock_guard lock(mutex_);
    if (!held_.insert(name).second) return std::nullopt;
    return Held(this, name);
  }

 private:
  void LetGo(const std::string& name) {
    {
      const std::lock_guard lock(mutex_);
      held_.erase(name);
    }
    let_go_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable let_go_;
  std::set<std::string> held_;
};

}  // namespace slicefarm::coordinator
