#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace slicefarm::coordinator {

/// A lock for each name. Whoever holds one, for however long, keeps nobody from the others.
/// Thread-safe; must outlive what is held.
class NameLocks {
 public:
  /// Lets go when destroyed.
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

  /// Waits while another one holds it.
  Held Take(const std::string& name) {
    std::unique_lock lock(mutex_);
    let_go_.wait(lock, [&] { return held_.insert(name).second; });
    return Held(this, name);
  }

  /// None: another one holds it.
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
