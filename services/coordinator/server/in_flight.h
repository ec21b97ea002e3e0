#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace slicefarm::coordinator {

/// Keeps the same work from being done twice at the same time: who comes second waits, and then
/// finds the result of the first in the cache. JobRunner claims no two jobs of one action; what is
/// left for here are jobs of an earlier build, whose action is another one by now. Thread-safe.
class InFlight {
 public:
  /// Held while the work of a digest is done.
  class Turn {
   public:
    Turn(InFlight& in_flight, std::string digest)
        : in_flight_(in_flight), digest_(std::move(digest)) {}
    ~Turn() { in_flight_.Leave(digest_); }
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    InFlight& in_flight_;
    std::string digest_;
  };

  /// Waits until nobody works on `digest`. False: `given_up` became true; otherwise a Turn has to
  /// follow.
  bool Enter(const std::string& digest, const std::function<bool()>& given_up);

 private:
  void Leave(const std::string& digest);

  std::mutex mutex_;
  std::condition_variable left_;
  std::set<std::string> digests_;
};

}  // namespace slicefarm::coordinator
