#include "services/coordinator/store/faults/crash_disk_test.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

namespace slicefarm::coordinator {
namespace {

namespace fs = std::filesystem;

constexpr int64_t kSectorBytes = 512;

bool Coin(std::mt19937_64& random) { return random() % 2 == 0; }

/// Writes bytes into `file`, also beyond its end. A gap is filled with zeros.
void Put(std::string& file, int64_t offset, std::string_view bytes) {
  const size_t end = offset + bytes.size();
  if (file.size() < end) file.resize(end, '\0');
  std::copy(bytes.begin(), bytes.end(), file.begin() + offset);
}

std::string ReadFile(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

ino_t InodeOf(const fs::path& path) {
  struct stat info {};
  lstat(path.c_str(), &info);
  return info.st_ino;
}

}  // namespace

CrashDisk CrashDisk::Of(const std::string& path) {
  CrashDisk disk;
  std::map<ino_t, int> nodes;  // a file may have two names
  const auto add = [&](const auto& self, const fs::path& directory, int parent) -> void {
    // Sorted by name, so that the order is the same every time.
    std::map<std::string, fs::directory_entry> entries;
    for (const auto& entry : fs::directory_iterator(directory))
      entries[entry.path().filename()] = entry;
    for (const auto& [name, entry] : entries) {
      const auto [known, fresh] = nodes.emplace(InodeOf(entry.path()), disk.next_node());
      const int node = known->second;
      disk.nodes_[parent].names[name] = disk.nodes_[parent].disk_names[name] = node;
      if (!fresh) continue;
      Node& made = disk.nodes_.emplace_back();
      made.is_directory = entry.is_directory();
      if (!made.is_directory) made.bytes = ReadFile(entry.path());
      made.size = static_cast<int64_t>(made.bytes.size());
      if (entry.is_directory()) self(self, entry.path(), node);
    }
  };
  add(add, path, kRoot);
  return disk;
}

std::optional<int> CrashDisk::Find(std::string_view path) const {
  int node = kRoot;
  while (!path.empty()) {
    const size_t slash = path.find('/');
    const std::string_view name = path.substr(0, slash);
    path = slash == std::string_view::npos ? "" : path.substr(slash + 1);
    if (name.empty() || name == ".") continue;
    const Names& names = nodes_[node].names;
    const auto found = names.find(name);
    if (found == names.end()) return std::nullopt;
    node = found->second;
  }
  return node;
}

void CrashDisk::SetName(int directory, const std::string& name, std::optional<int> node) {
  Node& parent = nodes_[directory];
  if (node) {
    parent.names[name] = *node;
  } else {
    parent.names.erase(name);
  }
  parent.pending_names.push_back({name, node});
}

void CrashDisk::Apply(const DiskChange& change) {
  using Kind = DiskChange::Kind;
  switch (change.kind) {
    case Kind::kCreate:
    case Kind::kMakeDirectory:
      nodes_.emplace_back().is_directory = change.kind == Kind::kMakeDirectory;
      return SetName(change.parent, change.name, change.node);
    case Kind::kUnlink:
      return SetName(change.parent, change.name, std::nullopt);
    case Kind::kRename:
      SetName(change.to_parent, change.to_name, nodes_[change.parent].names.at(change.name));
      return SetName(change.parent, change.name, std::nullopt);
    case Kind::kSync:
      return Sync(nodes_[change.node]);
    default:
      break;
  }
  Node& file = nodes_[change.node];
  const auto end = change.offset + static_cast<int64_t>(change.bytes.size());
  switch (change.kind) {
    case Kind::kWrite:
      file.pending.push_back({change.offset, change.bytes});
      file.size = std::max(file.size, end);
      break;
    case Kind::kTruncate:
      file.pending.push_back({change.offset, "", /*truncates=*/true});
      file.size = change.offset;
      break;
    case Kind::kSyncFailed:
      for (Write& write : file.pending) write.forgotten = !write.synced;
      break;
    default:  // kDamage
      file.pending.push_back({change.offset, change.bytes});
      file.pending.back().synced = true;
      Fold(file);
  }
}

/// Moves synced writes into the bytes of the file. Writes after a forgotten write are kept: if the
/// forgotten write reached the disk, it did so before them.
void CrashDisk::Fold(Node& file) {
  size_t settled = 0;
  for (; settled < file.pending.size() && file.pending[settled].synced; ++settled) {
    const Write& write = file.pending[settled];
    if (write.truncates) {
      file.bytes.resize(write.offset, '\0');
    } else {
      Put(file.bytes, write.offset, write.bytes);
    }
  }
  file.pending.erase(file.pending.begin(),
                     file.pending.begin() + static_cast<std::ptrdiff_t>(settled));
}

void CrashDisk::Sync(Node& node) {
  node.disk_names = node.names;
  node.pending_names.clear();
  for (Write& write : node.pending) write.synced = write.synced || !write.forgotten;
  Fold(node);
}

std::string CrashDisk::FileAfter(const Node& node, Leftover leftover,
                                 std::mt19937_64& random) const {
  std::string bytes = node.bytes;
  for (const Write& write : node.pending) {
    const Leftover left = write.synced ? Leftover::kEverything : leftover;
    if (left == Leftover::kNothing || (left == Leftover::kAnything && Coin(random))) continue;
    if (write.truncates) {
      bytes.resize(write.offset, '\0');
      continue;
    }
    const bool torn = left == Leftover::kAnything && Coin(random);
    const auto end = static_cast<int64_t>(write.offset + write.bytes.size());
    for (int64_t at = write.offset; at < end;) {
      const int64_t next = std::min(end, (at / kSectorBytes + 1) * kSectorBytes);
      if (!torn || Coin(random)) {
        Put(bytes, at, std::string_view(write.bytes).substr(at - write.offset, next - at));
      }
      at = next;
    }
  }
  const bool unsynced = std::any_of(node.pending.begin(), node.pending.end(),
                                    [](const Write& write) { return !write.synced; });
  if (unsynced && leftover == Leftover::kAnything && random() % 4 == 0) {
    // The size reached the disk, but not the bytes.
    bytes.resize(std::max<size_t>(bytes.size(), node.size), '\0');
  }
  return bytes;
}

CrashDisk::Names CrashDisk::NamesAfter(const Node& node, Leftover leftover,
                                       std::mt19937_64& random) const {
  if (leftover == Leftover::kEverything) return node.names;
  Names names = node.disk_names;
  if (leftover == Leftover::kNothing) return names;
  for (const NameChange& change : node.pending_names) {
    if (Coin(random)) continue;
    if (change.node) {
      names[change.name] = *change.node;
    } else {
      names.erase(change.name);
    }
  }
  return names;
}

void CrashDisk::WriteDirectory(int node, const std::string& path, Leftover leftover,
                               std::mt19937_64& random, std::map<int, std::string>& written) const {
  fs::create_directory(path);
  for (const auto& [name, child] : NamesAfter(nodes_[node], leftover, random)) {
    const std::string child_path = path + "/" + name;
    if (nodes_[child].is_directory) {
      WriteDirectory(child, child_path, leftover, random, written);
    } else if (const auto [other, fresh] = written.emplace(child, child_path); !fresh) {
      fs::create_hard_link(other->second, child_path);  // half of a rename
    } else {
      std::ofstream(child_path, std::ios::binary) << FileAfter(nodes_[child], leftover, random);
    }
  }
}

void CrashDisk::WriteImage(const std::string& path, Leftover leftover,
                           std::mt19937_64& random) const {
  std::map<int, std::string> written;
  WriteDirectory(kRoot, path, leftover, random, written);
}

}  // namespace slicefarm::coordinator
