#include "services/coordinator/algo/tar_entry.h"

#include <algorithm>

#include "absl/strings/str_format.h"

namespace slicefarm::coordinator {
namespace {

constexpr int64_t kBlockBytes = 512;
constexpr size_t kChecksumAt = 148;
constexpr size_t kChecksumBytes = 8;

}  // namespace

std::string TarHeader(std::string_view name, int64_t size, int64_t time_s) {
  std::string header(kBlockBytes, '\0');
  const auto put = [&](size_t at, std::string_view text) {
    std::ranges::copy(text, header.begin() + static_cast<std::ptrdiff_t>(at));
  };
  put(0, name);
  put(100, "0000600");                       // mode
  put(108, "0000000");                       // user
  put(116, "0000000");                       // group
  put(124, absl::StrFormat("%011o", size));  // bytes
  put(136, absl::StrFormat("%011o", std::max<int64_t>(time_s, 0)));
  put(kChecksumAt, std::string(kChecksumBytes, ' '));  // as it counts for itself
  put(156, "0");                                       // a file
  put(257, std::string_view("ustar\0"
                            "00",
                            8));  // magic, version
  unsigned sum = 0;
  for (const char byte : header) sum += static_cast<unsigned char>(byte);
  put(kChecksumAt, absl::StrFormat("%06o", sum) + std::string("\0 ", 2));
  return header;
}

std::string TarPadding(int64_t size) {
  return std::string(static_cast<size_t>((kBlockBytes - size % kBlockBytes) % kBlockBytes), '\0');
}

std::string TarEnd() { return std::string(2 * kBlockBytes, '\0'); }

}  // namespace slicefarm::coordinator
