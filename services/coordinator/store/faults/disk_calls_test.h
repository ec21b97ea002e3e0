#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "services/coordinator/store/faults/crash_disk_test.h"

namespace slicefarm::coordinator {

/// What goes wrong with a call.
enum class Fault {
  kEio,
  kNoSpace,  ///< ENOSPC
  kQuota,    ///< EDQUOT
  kEintr,
  kShort,  ///< half of what was to be written or read
};
std::string_view FaultName(Fault fault);

/// A call that could have gone wrong.
struct DiskCall {
  std::string function;
  std::string path;           ///< below the root
  std::vector<Fault> faults;  ///< what may happen to it
};

/// fsyncs that do not tell the disk: what the tests of these tests turn on.
enum class Lie { kNone, kFiles, kDirectories };

/// Stands between this process, SQLite included, and the C library's file calls for all files below
/// a directory, as long as it lives: notes what they change, in their order, and lets chosen ones
/// fail. Nothing waits for the disk: an fsync is noted, and not done.
///
/// One at a time, and for calls of one thread.
class DiskCalls {
 public:
  explicit DiskCalls(std::string root, Lie lie = Lie::kNone);
  ~DiskCalls();
  DiskCalls(const DiskCalls&) = delete;
  DiskCalls& operator=(const DiskCalls&) = delete;

  /// Call number `call`, from 0 on, fails. If it `lasts`, so do all that follow until Heal(); a
  /// short write that lasts is one of a disk that is full then. What cannot happen to a call does
  /// not happen to it.
  void FailAt(int64_t call, Fault fault, bool lasts);
  void Heal();
  /// Whether a call has failed.
  bool struck() const { return struck_; }

  /// Bytes change by themselves, as on a worn-out disk.
  void Damage(const std::string& path, int64_t offset, const std::string& bytes);

  const std::vector<DiskCall>& calls() const { return calls_; }
  const std::vector<DiskChange>& changes() const { return changes_; }
  /// Before the first change, and after all of them.
  const CrashDisk& before() const { return before_; }
  const CrashDisk& now() const { return disk_; }

  /// Names of the functions that it stands before.
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
  /// Counts a call. 0, or the errno that it ends with; `bytes` may become fewer.
  int Strike(const char* function, std::string_view path, std::vector<Fault> faults, size_t* bytes);

  const std::string root_;
  const Lie lie_;
  const CrashDisk before_;
  CrashDisk disk_;
  std::map<int, File> files_;  ///< by descriptor
  std::vector<DiskCall> calls_;
  std::vector<DiskChange> changes_;

  int64_t fail_at_ = -1;
  Fault fault_ = Fault::kEio;
  bool lasts_ = false;
  bool failing_ = false;
  bool struck_ = false;
};

}  // namespace slicefarm::coordinator
