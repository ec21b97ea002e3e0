#pragma once

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace slicefarm {

/// Returns the bytes of a file of tests/corpus, such as "models/benchy.stl". Aborts if the file
/// cannot be read, because no test or benchmark works without its input. Targets that use it define
/// SLICEFARM_CORPUS.
inline std::string CorpusFile(const std::string& name) {
  const std::string path = SLICEFARM_CORPUS "/" + name;
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (file.is_open() && !file.bad() && !bytes.empty()) return bytes;
  std::fprintf(stderr, "%s cannot be read\n", path.c_str());
  std::abort();
}

}  // namespace slicefarm
