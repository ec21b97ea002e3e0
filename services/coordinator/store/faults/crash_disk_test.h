#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace slicefarm::coordinator {

/// Call that changed files or requested a sync. Files and directories are identified by numbers,
/// because a file that was renamed or removed can still be written to.
struct DiskChange {
  /// Kind of a change.
  enum class Kind {
    kCreate,         ///< creates file `node` under `name` in directory `parent`
    kMakeDirectory,  ///< creates directory `node` under `name` in directory `parent`
    kUnlink,         ///< removes `name` from `parent`
    kRename,         ///< renames `name` in `parent` to `to_name` in `to_parent`
    kWrite,          ///< writes `bytes` at `offset` of `node`
    kTruncate,       ///< cuts `node` to `offset` bytes
    kSync,           ///< fsync of a file or a directory
    kSyncFailed,     ///< fsync that returned an error
    kDamage,         ///< `bytes` at `offset` of `node` changed without a call
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

/// Unsynced changes that survive a power cut.
enum class Leftover {
  kNothing,
  kEverything,
  /// Any subset of the writes, in sectors of 512 bytes, and of the names; sizes without bytes.
  kAnything,
};

/// Directory tree as a disk stores it. Models the state of the disk after a power cut.
///
/// - Bytes are safe after a sync of their file; a name is safe after a sync of its directory.
///   Before that, writes, names and sizes reach the disk in any order. A rename consists of two
///   names.
/// - A failed fsync forgets the pending writes: they count as written, and no later fsync writes
///   them. Linux behaves like this ("fsyncgate": Rebello et al., "Can Applications Recover from
///   fsync Failures?", USENIX ATC 2020). Directories do not forget, because file systems keep a
///   journal of names and stop if it cannot be written.
///
/// It is a value: a copy preserves the state at some moment.
class CrashDisk {
 public:
  static constexpr int kRoot = 0;

  /// Returns the content of directory `path`; all of it is on disk.
  static CrashDisk Of(const std::string& path);

  CrashDisk() : nodes_(1) { nodes_[kRoot].is_directory = true; }

  /// Applies a change.
  void Apply(const DiskChange& change);

  /// Returns the node of `path`, relative to the root, in the state without a power cut.
  std::optional<int> Find(std::string_view path) const;
  /// Returns true if the node is a directory.
  bool IsDirectory(int node) const { return nodes_[node].is_directory; }
  /// Returns the size of a file without a power cut.
  int64_t SizeOf(int node) const { return nodes_[node].size; }
  /// Returns the number of the next node that is created.
  int next_node() const { return static_cast<int>(nodes_.size()); }

  /// Creates directory `path` with the content after a power cut. Equal states of `random` create
  /// equal trees.
  void WriteImage(const std::string& path, Leftover leftover, std::mt19937_64& random) const;

 private:
  using Names = std::map<std::string, int, std::less<>>;

  /// A write, or a truncation to `offset` without bytes.
  struct Write {
    int64_t offset = 0;
    std::string bytes;
    bool truncates = false;
    bool synced = false;
    bool forgotten = false;
  };
  struct NameChange {
    std::string name;
    std::optional<int> node;  ///< empty if the name is removed
  };
  struct Node {
    bool is_directory = false;
    std::string bytes;           ///< bytes of a file on disk
    std::vector<Write> pending;  ///< writes after these bytes
    int64_t size = 0;            ///< size with all writes
    Names names;                 ///< current names in a directory
    Names disk_names;            ///< names on disk
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
