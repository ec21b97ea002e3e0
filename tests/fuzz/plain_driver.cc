// Runs a fuzz target without libFuzzer, with any compiler: over its seeds, and for some seconds
// over random changes of them. It ignores coverage; the preset `fuzz` uses it.
//
//   fuzz_x DIR [SECONDS SEED]
//
// The current input is in the file `last-input` of the working directory. After a crash, it is the
// input that caused it.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

using Bytes = std::vector<uint8_t>;

constexpr size_t kMaxBytes = 4096;

std::minstd_rand& Random() {
  static std::minstd_rand random;
  return random;
}

std::vector<Bytes> ReadSeeds(const std::string& directory) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (entry.is_regular_file()) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Bytes> seeds;
  for (const std::string& path : paths) {
    std::ifstream file(path, std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return seeds;
}

void Try(const Bytes& input, bool keep) {
  if (keep) {
    std::ofstream("last-input", std::ios::binary)
        .write(reinterpret_cast<const char*>(input.data()),
               static_cast<std::streamsize>(input.size()));
  }
  LLVMFuzzerTestOneInput(input.data(), input.size());
}

}  // namespace

/// Replacement of libFuzzer's mutation function for mutators of messages. It changes some bytes,
/// removes some, or inserts some.
extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size) {
  auto& random = Random();
  if (size == 0 || (random() % 4 == 0 && size < max_size)) {
    const size_t at = random() % (size + 1);
    std::copy_backward(data + at, data + size, data + size + 1);
    data[at] = static_cast<uint8_t>(random());
    return size + 1;
  }
  const size_t at = random() % size;
  if (random() % 4 == 0) {
    const size_t count = 1 + random() % (size - at);
    std::copy(data + at + count, data + size, data + at);
    return size - count;
  }
  if (random() % 2 == 0) {
    data[at] ^= static_cast<uint8_t>(1U << random() % 8);
  } else {
    constexpr uint8_t kEdges[] = {0, 1, 0x7f, 0x80, 0xff, '0', '9', '-', '.', ' ', '\n'};
    data[at] = kEdges[random() % std::size(kEdges)];
  }
  return size;
}

/// Default mutator. A target with its own mutator replaces it.
extern "C" __attribute__((weak)) size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size,
                                                                size_t max_size,
                                                                unsigned int /*seed*/) {
  return LLVMFuzzerMutate(data, size, max_size);
}

namespace {

Bytes Mutated(Bytes input) {
  size_t size = std::min(input.size(), kMaxBytes);
  input.resize(kMaxBytes + 1);
  for (size_t times = 1 + Random()() % 4; times > 0; --times) {
    size = LLVMFuzzerCustomMutator(input.data(), size, kMaxBytes,
                                   static_cast<unsigned int>(Random()()));
  }
  input.resize(size);
  return input;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4) {
    std::fprintf(stderr, "usage: %s DIR [SECONDS SEED]\n", argv[0]);
    return 2;
  }
  const std::vector<Bytes> seeds = ReadSeeds(argv[1]);
  if (seeds.empty()) {
    std::fprintf(stderr, "%s has no seeds\n", argv[1]);
    return 1;
  }
  for (const Bytes& seed : seeds) Try(seed, /*keep=*/false);
  int64_t tried = 0;
  if (argc == 4) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(std::atoi(argv[2]));
    Random().seed(static_cast<unsigned int>(std::atoi(argv[3])));
    for (; std::chrono::steady_clock::now() < end; ++tried)
      Try(Mutated(seeds[Random()() % seeds.size()]), /*keep=*/true);
    std::filesystem::remove("last-input");
  }
  std::printf("%zu seeds, %lld changed ones\n", seeds.size(), static_cast<long long>(tried));
}
