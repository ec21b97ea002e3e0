#pragma once

#include <functional>
#include <memory>
#include <string>

namespace slicefarm::coordinator {

/// A place for a store, which can be opened again and again.
template <typename Store>
class StorePlace {
 public:
  virtual ~StorePlace() = default;
  virtual std::unique_ptr<Store> Open() = 0;
};

/// An implementation that must keep the contract.
template <typename Store>
struct StoreKind {
  std::string name;
  std::function<std::unique_ptr<StorePlace<Store>>()> place;
};

}  // namespace slicefarm::coordinator
