#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "services/coordinator/store/faults/crash_disk_test.h"

namespace slicefarm::coordinator {

/// Fault of a call.
enum class Fault {
  kEio,
  kNoSpace,  ///< ENOSPC
  kQuota,    ///< EDQUOT
  kEintr,
  kShort,  ///< only half of the bytes are written or read
};
/// Returns the name of a fault.
std::string_view FaultName(Fault fault);

/// Call that can fail.
struct DiskCall {
  std::string function;
  std::string path;           ///< path below the root
  std::vector<Fault> faults;  ///< faults that may occur
};

/// Kinds of fsync calls that have no effect. With them, the tests check that the fault tests find
/// errors.
enum class Lie { kNone, kFiles, kDirectories };

/// Intercepts the C library's file calls of this program, including SQLite, for all files below a
/// directory during its lifetime. Records the changes in their order, and lets selected calls fail.
/// No call waits for the disk: an fsync is recorded but not made.
///
/// Only one object may exist at a time, and only one thread may make calls.
class DiskCalls {
 public:
  explicit DiskCalls(std::string root, Lie lie = Lie::kNone);
  ~DiskCalls();
  DiskCalls(const DiskCalls&) = delete;
  DiskCalls& operator=(const DiskCalls&) = delete;

  /// Lets call number `call` fail, counted from 0. If it `lasts`, all later calls fail until
  /// Heal(). A lasting short write means that the disk is full afterwards. Faults that cannot occur
  /// in a call have no effect on it.
  void FailAt(int64_t call, Fault fault, bool lasts);
  /// Ends the failures.
  void Heal();
  /// Returns true if a call has failed.
  bool struck() const { return struck_; }

  /// Changes bytes without a call, as a worn-out disk does.
  void Damage(const std::string& path, int64_t offset, const std::string& bytes);

  /// Returns the calls so far.
  const std::vector<DiskCall>& calls() const { return calls_; }
  /// Returns the changes so far.
  const std::vector<DiskChange>& changes() const { return changes_; }
  /// Returns the disk before the first change.
  const CrashDisk& before() const { return before_; }
  /// Returns the disk after all changes.
  const CrashDisk& now() const { return disk_; }

  /// Returns the names of the intercepted functions.
  static std::vector<std::string> Functions();

 private:
  friend class LibcHooks;

  struct Place {
    int directory = 0;
    std::string name;
  };
  struct File {
    int node = 0;
    std::string path;
  };

  bool Holds(std::string_view path) const;
  bool Holds(int fd) const { return files_.contains(fd); }
  std::string Below(std::string_view path) const;
  Place PlaceOf(std::string_view path) const;
  void Note(DiskChange change);
  /// Counts a call. Returns 0, or the errno with which the call must fail. May reduce `bytes`.
  int Strike(const char* function, std::string_view path, std::vector<Fault> faults, size_t* bytes);

  const std::string root_;
  const Lie lie_;
  const CrashDisk before_;
  CrashDisk disk_;
  std::map<int, File> files_;  ///< open files by descriptor
  std::vector<DiskCall> calls_;
  std::vector<DiskChange> changes_;

  int64_t fail_at_ = -1;
  Fault fault_ = Fault::kEio;
  bool lasts_ = false;
  bool failing_ = false;
  bool struck_ = false;
};

}  // namespace slicefarm::coordinator
