// Library for LD_PRELOAD into a worker. It kills the worker as soon as it has read the poison: a
// corner of an outline at (7.65625, -7.65625) mm in its wire format (sfixed32 nanometres).

#include <dlfcn.h>
#include <signal.h>
#include <sys/socket.h>

#include <array>
#include <cstdint>
#include <cstring>

namespace {

constexpr int32_t kPoison[] = {7'656'250, -7'656'250};
constexpr size_t kLess = sizeof(kPoison) - 1;

/// Searches bytes as they arrive, in pieces of any size.
class Taster {
 public:
  void Taste(const char* bytes, size_t size) {
    for (size_t i = 0; i < size; ++i) {
      std::memmove(last_.data(), last_.data() + 1, kLess);
      last_[kLess] = bytes[i];
      if (std::memcmp(last_.data(), kPoison, sizeof(kPoison)) == 0) raise(SIGKILL);
    }
  }

 private:
  std::array<char, sizeof(kPoison)> last_ = {};
};

/// State by descriptor. Only one thread at a time reads a socket.
std::array<Taster, 1024> tasters;

}  // namespace

extern "C" ssize_t recvmsg(int socket, msghdr* message, int flags) {
  using Receive = ssize_t (*)(int, msghdr*, int);
  static const auto real = reinterpret_cast<Receive>(dlsym(RTLD_NEXT, "recvmsg"));
  const ssize_t got = real(socket, message, flags);
  if (got <= 0 || socket < 0 || socket >= static_cast<int>(tasters.size())) return got;
  auto left = static_cast<size_t>(got);
  for (size_t i = 0; i < message->msg_iovlen && left > 0; ++i) {
    const size_t size = message->msg_iov[i].iov_len < left ? message->msg_iov[i].iov_len : left;
    tasters[static_cast<size_t>(socket)].Taste(
        static_cast<const char*>(message->msg_iov[i].iov_base), size);
    left -= size;
  }
  return got;
}
