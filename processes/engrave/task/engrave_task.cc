#include "processes/engrave/task/engrave_task.h"

#include <iterator>

#include "absl/hash/hash.h"

namespace slicefarm {

size_t EngraveResult::Print() const {
  size_t print = layers.size();
  for (const EngravedLayer& layer : layers)
    print = absl::HashOf(print, layer.numbers.layer, layer.text);
  return print;
}

int64_t EngraveResult::ProgramBytes() const {
  int64_t bytes = 0;
  for (const EngravedLayer& layer : layers) bytes += std::ssize(layer.text);
  return bytes;
}

}  // namespace slicefarm
