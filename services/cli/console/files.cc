#include "services/cli/console/files.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <set>
#include <utility>

#include "common/base/error.h"
#include "common/gcode/binary/binary_gcode_reader.h"
#include "services/cli/console/input_files.h"

namespace slicefarm::cli {
namespace {

constexpr mode_t kMode = 0666;  // without the bits of the umask

struct Descriptor {
  explicit Descriptor(int n) : number(n) {}
  ~Descriptor() {
    if (number >= 0) close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  const int number;
};

absl::Status ReadError(const std::string& path, int error_number) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("cannot read {}: {}", path, std::strerror(error_number)));
}

absl::Status WriteError(const std::string& path, int error_number) {
  return absl::DataLossError(fmt::format("cannot write {}: {}", path, std::strerror(error_number)));
}

absl::Status TooLarge(const std::string& path, int64_t limit, int64_t got) {
  return LimitError(Reason::kRequestTooLarge, path + ": bytes", limit, got);
}

/// Returns true if a new file can replace the file at `path`.
bool Replaceable(const std::string& path) {
  struct stat info = {};
  if (stat(path.c_str(), &info) != 0) return true;
  return S_ISREG(info.st_mode);
}

absl::Status WouldReplaceInput(const std::string& path) {
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
      fmt::format(
          "{} is also an input, which the output would replace: give the output another name",
          path));
}

/// Returns the target if `path` is a symbolic link, so that the link itself stays.
std::string Target(const std::string& path) {
  char* real = realpath(path.c_str(), nullptr);
  if (real == nullptr) return path;
  std::string target = real;
  std::free(real);
  return target;
}

/// Temporary files of OutputFiles that are not committed.
class PartialFiles {
 public:
  /// Returns the only instance. It is never destroyed, since a thread that ends the program may use
  /// it at any time.
  static PartialFiles& All() {
    static auto* all = new PartialFiles;
    return *all;
  }

  /// Opens a new file. Returns its descriptor, or -1 and sets errno.
  int Open(const std::string& path) {
    const std::lock_guard lock(mutex_);
    const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode);
    if (descriptor >= 0) paths_.insert(path);
    return descriptor;
  }

  /// Renames a file to its final name. Returns 0, or -1 and sets errno.
  int Rename(const std::string& path, const std::string& to) {
    const std::lock_guard lock(mutex_);
    const int renamed = std::rename(path.c_str(), to.c_str());
    if (renamed == 0) paths_.erase(path);
    return renamed;
  }

  void Remove(const std::string& path) {
    const std::lock_guard lock(mutex_);
    unlink(path.c_str());
    paths_.erase(path);
  }

  /// Removes all files. Later calls of Open and Rename block forever.
  void RemoveForGood() {
    mutex_.lock();
    for (const std::string& path : paths_) unlink(path.c_str());
  }

 private:
  std::mutex mutex_;
  std::set<std::string> paths_;
};

/// Reads and closes the descriptor. `name`: name for errors.
absl::StatusOr<std::string> ReadWhole(int descriptor, const std::string& name, int64_t max_bytes) {
  const Descriptor file(descriptor);
  if (file.number < 0) return ReadError(name, errno);
  struct stat info = {};
  if (fstat(file.number, &info) != 0) return ReadError(name, errno);
  NoteInput(file.number);
  const bool regular = S_ISREG(info.st_mode);
  if (regular && info.st_size > max_bytes) return TooLarge(name, max_bytes, info.st_size);

  constexpr size_t kBlock = 1 << 20;
  // + 1 to detect the end of the file.
  std::string bytes(regular ? info.st_size + 1 : kBlock, '\0');
  size_t size = 0;
  for (;;) {
    if (size == bytes.size()) bytes.resize(size + kBlock);
    const ssize_t got = read(file.number, bytes.data() + size, bytes.size() - size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return ReadError(name, errno);
    if (got == 0) break;
    size += got;
    if (static_cast<int64_t>(size) > max_bytes) return TooLarge(name, max_bytes, size);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

void RemovePartialFiles() { PartialFiles::All().RemoveForGood(); }

absl::StatusOr<std::string> ReadFile(const std::string& path, int64_t max_bytes) {
  if (path != "-") return ReadWhole(open(path.c_str(), O_RDONLY | O_CLOEXEC), path, max_bytes);
  static const auto* const input =
      new absl::StatusOr<std::string>(ReadWhole(dup(STDIN_FILENO), "standard input", max_bytes));
  return *input;
}

absl::StatusOr<std::string> ReadText(const std::string& path, int64_t max_bytes, int plate) {
  auto text = ReadFile(path, max_bytes);
  if (!text.ok()) return text;
  const bool archive = gcode::IsGcodeArchive(*text), binary = gcode::IsBinaryGcode(*text);
  if (!archive && plate > 1)
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     fmt::format("{}: only a .gcode.3mf archive has a plate {}", path, plate));
  if (!archive && !binary) return text;
  auto unpacked = archive ? gcode::TextOfPlate(*text, plate) : gcode::TextOfBinaryGcode(*text);
  if (unpacked.ok()) return unpacked;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("{}: {}", path, std::string(unpacked.status().message())));
}

absl::Status InFile(const std::string& path, const absl::Status& status) {
  const ErrorDetail detail = DetailOf(status);
  return MakeError(status.code(), detail.reason,
                   fmt::format("{}: {}", path, std::string(status.message())), detail.metadata);
}

absl::StatusOr<OutputFile> OutputFile::Create(const std::string& path) {
  if (path == "-") return OutputFile("standard output", "", dup(STDOUT_FILENO));
  if (IsInput(path)) return WouldReplaceInput(path);
  const std::string target = Target(path);
  const bool replaceable = Replaceable(target);
  const std::string temporary = replaceable ? fmt::format("{}.{}.part", target, getpid()) : "";
  const int descriptor = replaceable ? PartialFiles::All().Open(temporary)
                                     : open(target.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return WriteError(path, errno);
  }
  return OutputFile(target, temporary, descriptor);
}

absl::Status CheckWritable(const std::string& path) {
  if (path.empty() || path == "-" || !Replaceable(Target(path))) return absl::OkStatus();
  return OutputFile::Create(path).status();
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, "")),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!temporary_.empty()) PartialFiles::All().Remove(temporary_);
}

absl::Status OutputFile::Error(int error_number) const { return WriteError(path_, error_number); }

absl::Status OutputFile::Write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return Error(errno);
    bytes.remove_prefix(written);
  }
  return absl::OkStatus();
}

absl::Status OutputFile::Commit() {
  if (close(std::exchange(descriptor_, -1)) != 0) return Error(errno);
  if (temporary_.empty()) return absl::OkStatus();
  if (PartialFiles::All().Rename(temporary_, path_) != 0) return Error(errno);
  temporary_.clear();
  return absl::OkStatus();
}

absl::Status WriteFile(const std::string& path, std::string_view bytes) {
  auto file = OutputFile::Create(path);
  if (!file.ok()) return file.status();
  if (absl::Status status = file->Write(bytes); !status.ok()) return status;
  return file->Commit();
}

absl::Status WriteFile(const std::string& path, const SpooledText& text) {
  auto file = OutputFile::Create(path);
  if (!file.ok()) return file.status();
  const absl::Status status =
      text.ForEachBlock([&](std::string_view bytes) { return file->Write(bytes); });
  if (!status.ok()) return status;
  return file->Commit();
}

}  // namespace slicefarm::cli
