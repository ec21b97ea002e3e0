#include "services/coordinator/remote/address_watch.h"

#include <fmt/core.h>
#include <netdb.h>
#include <sys/socket.h>

#include <array>
#include <memory>
#include <set>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

using AddressList = std::unique_ptr<addrinfo, decltype(&freeaddrinfo)>;

struct HostPort {
  std::string host;
  std::string port;
};

absl::StatusOr<HostPort> Split(const std::string& name) {
  const size_t colon = name.rfind(':');
  if (colon == std::string::npos || colon == 0 || colon + 1 == name.size()) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     fmt::format("'{}' is not host:port", name), {{"address", name}});
  }
  std::string host = name.substr(0, colon);
  if (host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  return HostPort{host, name.substr(colon + 1)};
}

/// Returns the numeric addresses of one family, sorted.
std::set<std::string> OfFamily(const addrinfo* list, int family) {
  std::set<std::string> addresses;
  for (const addrinfo* entry = list; entry != nullptr; entry = entry->ai_next) {
    std::array<char, NI_MAXHOST> host = {};
    std::array<char, NI_MAXSERV> port = {};
    if (entry->ai_family != family ||
        getnameinfo(entry->ai_addr, entry->ai_addrlen, host.data(), host.size(), port.data(),
                    port.size(), NI_NUMERICHOST | NI_NUMERICSERV) != 0) {
      continue;
    }
    addresses.insert(fmt::format(fmt::runtime(family == AF_INET6 ? "[{}]:{}" : "{}:{}"),
                                 host.data(), port.data()));
  }
  return addresses;
}

}  // namespace

absl::StatusOr<std::vector<std::string>> ResolveByDns(const std::string& name) {
  const absl::StatusOr<HostPort> parts = Split(name);
  if (!parts.ok()) return parts.status();
  addrinfo hints = {};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(parts->host.c_str(), parts->port.c_str(), &hints, &found);
  if (error != 0) {
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                     fmt::format("cannot resolve {}: {}", name, gai_strerror(error)),
                     {{"address", name}});
  }
  const AddressList list(found, &freeaddrinfo);
  std::set<std::string> addresses = OfFamily(list.get(), AF_INET);
  if (addresses.empty()) addresses = OfFamily(list.get(), AF_INET6);
  return std::vector<std::string>(addresses.begin(), addresses.end());
}

std::vector<std::string> SplitAddresses(std::string_view list) {
  std::vector<std::string> names;
  while (!list.empty()) {
    const size_t comma = std::min(list.find(','), list.size());
    if (comma > 0) names.emplace_back(list.substr(0, comma));
    list.remove_prefix(std::min(comma + 1, list.size()));
  }
  return names;
}

AddressWatch::AddressWatch(std::vector<std::string> names,
                           std::function<void(const std::vector<std::string>&)> changed,
                           AddressWatchOptions options)
    : names_(std::move(names)),
      changed_(std::move(changed)),
      options_(std::move(options)),
      thread_([this](const std::stop_token& stop) { Loop(stop); }) {}

void AddressWatch::Refresh() {
  {
    const std::lock_guard lock(mutex_);
    refresh_ = true;
  }
  wake_.notify_all();
}

std::vector<std::string> AddressWatch::Look() {
  std::set<std::string> all;
  for (const std::string& name : names_) {
    absl::StatusOr<std::vector<std::string>> addresses = options_.resolve(name);
    if (addresses.ok()) known_[name] = *std::move(addresses);
    all.insert(known_[name].begin(), known_[name].end());
  }
  return {all.begin(), all.end()};
}

void AddressWatch::Loop(const std::stop_token& stop) {
  std::vector<std::string> reported;
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    refresh_ = false;
    lock.unlock();
    std::vector<std::string> addresses = Look();
    if (addresses != reported) {
      changed_(addresses);
      reported = std::move(addresses);
    }
    lock.lock();
    wake_.wait_for(lock, stop, options_.least_pause, [] { return false; });
    wake_.wait_for(lock, stop, options_.every - options_.least_pause, [this] { return refresh_; });
  }
}

}  // namespace slicefarm::coordinator
