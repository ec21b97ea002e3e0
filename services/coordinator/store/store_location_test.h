#pragma once

#include <functional>
#include <memory>
#include <string>

namespace slicefarm::coordinator {

/// Location of a store. The store can be opened there several times.
template <typename Store>
class StoreLocation {
 public:
  virtual ~StoreLocation() = default;
  /// Opens the store.
  virtual std::unique_ptr<Store> Open() = 0;
};

/// Implementation that must fulfil the contract.
template <typename Store>
struct StoreKind {
  std::string name;
  std::function<std::unique_ptr<StoreLocation<Store>>()> location;
};

}  // namespace slicefarm::coordinator
