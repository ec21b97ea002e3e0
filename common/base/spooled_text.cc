#include "common/base/spooled_text.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

namespace slicefarm {
namespace {

/// Buffer that collects the bytes of pieces and passes them on in blocks of kBlockBytes.
class Blocks {
 public:
  explicit Blocks(const SpooledText::Visit& visit)
      : visit_(visit), block_(static_cast<size_t>(SpooledText::kBlockBytes)) {}

  /// Adds a piece of `size` bytes. `fill(offset, bytes)` reads the piece's bytes from `offset` on
  /// into `bytes`.
  template <typename Fill>
  absl::Status Take(int64_t size, const Fill& fill) {
    for (int64_t done = 0; done < size;) {
      const int64_t count = std::min(size - done, SpooledText::kBlockBytes - used_);
      absl::Status filled = fill(done, std::span(block_).subspan(Index(used_), Index(count)));
      if (!filled.ok()) return filled;
      done += count;
      used_ += count;
      if (used_ < SpooledText::kBlockBytes) continue;
      if (absl::Status visited = Flush(); !visited.ok()) return visited;
    }
    return absl::OkStatus();
  }

  absl::Status Flush() {
    if (used_ == 0) return absl::OkStatus();
    return visit_({block_.data(), Index(std::exchange(used_, 0))});
  }

 private:
  static size_t Index(int64_t n) { return static_cast<size_t>(n); }

  const SpooledText::Visit& visit_;
  std::vector<char> block_;
  int64_t used_ = 0;
};

}  // namespace

void SpooledText::Add(std::string text) {
  if (text.empty()) return;
  size_ += std::ssize(text);
  pieces_.emplace_back(std::move(text));
}

void SpooledText::Add(SpoolFile::Chunk chunk) {
  if (chunk.size == 0) return;
  size_ += chunk.size;
  pieces_.emplace_back(chunk);
}

absl::Status SpooledText::ForEachBlock(const Visit& visit) const {
  Blocks blocks(visit);
  for (const auto& piece : pieces_) {
    absl::Status taken;
    if (const auto* text = std::get_if<std::string>(&piece)) {
      taken = blocks.Take(std::ssize(*text), [&](int64_t offset, std::span<char> bytes) {
        std::memcpy(bytes.data(), text->data() + offset, bytes.size());
        return absl::OkStatus();
      });
    } else {
      const auto& chunk = std::get<SpoolFile::Chunk>(piece);
      taken = blocks.Take(chunk.size, [&](int64_t offset, std::span<char> bytes) {
        return spool_->ReadAt(chunk.offset + offset, bytes);
      });
    }
    if (!taken.ok()) return taken;
  }
  return blocks.Flush();
}

/// Appends `count` bytes of a piece, from `offset` in the piece.
absl::Status SpooledText::Append(const Piece& piece, int64_t offset, int64_t count,
                                 std::string& text) const {
  if (const auto* part = std::get_if<std::string>(&piece)) {
    text.append(*part, static_cast<size_t>(offset), static_cast<size_t>(count));
    return absl::OkStatus();
  }
  const size_t have = text.size();
  text.resize(have + static_cast<size_t>(count));
  const auto& chunk = std::get<SpoolFile::Chunk>(piece);
  return spool_->ReadAt(chunk.offset + offset, std::span(text).subspan(have));
}

absl::StatusOr<std::string> SpooledText::Read(int64_t offset, int64_t limit) const {
  std::string text;
  int64_t begin = 0;  // of the piece
  for (const Piece& piece : pieces_) {
    const auto* part = std::get_if<std::string>(&piece);
    const int64_t size =
        part != nullptr ? std::ssize(*part) : std::get<SpoolFile::Chunk>(piece).size;
    const int64_t from = offset + std::ssize(text) - begin;
    const int64_t count = std::min(size - from, limit - std::ssize(text));
    begin += size;
    if (count <= 0) continue;
    if (absl::Status read = Append(piece, from, count, text); !read.ok()) return read;
    if (std::ssize(text) == limit) break;
  }
  return text;
}

absl::StatusOr<std::string> SpooledText::Whole() const {
  std::string text;
  text.reserve(static_cast<size_t>(size_));
  const absl::Status read = ForEachBlock([&](std::string_view bytes) {
    text += bytes;
    return absl::OkStatus();
  });
  if (!read.ok()) return read;
  return text;
}

}  // namespace slicefarm
