#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace slicefarm::coordinator {

/// A call that changed files or asked for them to be on disk. Files and directories go by number,
/// as a file that was renamed or removed can still be written to.
struct DiskChange {
  enum class Kind {
    kCreate,         ///< a file: `node`, under `name` in directory `parent`
    kMakeDirectory,  ///< the same, a directory
    kUnlink,         ///< `name` leaves `parent`
    kRename,         ///< `name` in `parent` becomes `to_name` in `to_parent`
    kWrite,          ///< `bytes` at `offset` of `node`
    kTruncate,       ///< `node` to `offset` bytes
    kSync,           ///< fsync of a file or a directory
    kSyncFailed,     ///< fsync that told of an error
    kDamage,         ///< `bytes` at `offset` of `node` change by themselves: no call did it
  };
  Kind kind = Kind::kSync;
  int node = 0;
  int parent = 0;
  std::string name = {};
  int to_parent = 0;
  std::string to_name = {};
  int64_t offset = 0;
  std::string bytes = {};
};

/// What of the unsynced a power cut leaves.
enum class Leftover {
  kNothing,
  kEverything,
  kAnything,  ///< any of the writes, in sectors of 512 bytes; any of the names; sizes without bytes
};

/// A directory tree as a disk keeps it: what is there if the power fails now?
///
/// - Bytes are certain once their file was synced, and a name once the directory that it stands in
///   was. Writes, names and sizes reach the disk in any order before; a rename is two names.
/// - An fsync that fails forgets: what was to be written counts as clean and no later fsync writes
///   it, which is what Linux does ("fsyncgate": Rebello et al., "Can Applications Recover from
///   fsync Failures?", USENIX ATC 2020). Directories are not forgetful: file systems keep a journal
///   of names, and stop if it cannot be written.
///
/// A value: what a disk would leave is asked of a copy of some moment.
class CrashDisk {
 public:
  static constexpr int kRoot = 0;

  /// What is in directory `path` now, all of it on disk.
  static CrashDisk Of(const std::string& path);

  CrashDisk() : nodes_(1) { nodes_[kRoot].is_directory = true; }

  void Apply(const DiskChange& change);

  /// The node that `path`, relative to the root, leads to for those who have not lost power.
  std::optional<int> Find(std::string_view path) const;
  bool IsDirectory(int node) const { return nodes_[node].is_directory; }
  int64_t SizeOf(int node) const { return nodes_[node].size; }
  /// The number of the next node that is made.
  int next_node() const { return static_cast<int>(nodes_.size()); }

  /// Makes directory `path` and in it what a power cut leaves. Equal states of `random`, equal
  /// trees.
  void WriteImage(const std::string& path, Leftover leftover, std::mt19937_64& random) const;

 private:
  using Names = std::map<std::string, int, std::less<>>;

  /// A write, or with no bytes a truncation to `offset`.
  struct Write {
    int64_t offset = 0;
    std::string bytes;
    bool truncates = false;
    bool synced = false;
    bool forgotten = false;
  };
  struct NameChange {
    std::string name;
    std::optional<int> node;  ///< none: the name goes
  };
  struct Node {
    bool is_directory = false;
    std::string bytes;           ///< of a file: on disk
    std::vector<Write> pending;  ///< and what came after
    int64_t size = 0;            ///< with all of that
    Names names;                 ///< of a directory, now
    Names disk_names;            ///< and on disk
    std::vector<NameChange> pending_names;
  };

  void SetName(int directory, const std::string& name, std::optional<int> node);
  static void Sync(Node& node);
  static void Fold(Node& file);
  std::string FileAfter(const Node& node, Leftover leftover, std::mt19937_64& random) const;
  Names NamesAfter(const Node& node, Leftover leftover, std::mt19937_64& random) const;
  void WriteDirectory(int node, const std::string& path, Leftover leftover, std::mt19937_64& random,
                      std::map<int, std::string>& written) const;

  std::vector<Node> nodes_;
};

}  // namespace slicefarm::coordinator
