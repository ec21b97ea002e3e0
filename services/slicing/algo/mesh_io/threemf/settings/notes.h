#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicefarm::slicing::threemf {

/// What has no effect, of which objects: "painted filaments of `a`, `b` and 3 more".
class Notes {
 public:
  /// `object`: its name; empty: of the file.
  void Add(std::string_view what, std::string_view object);
  /// One line for each `what`, in the order in which they were first added.
  std::vector<std::string> Lines() const;

 private:
  struct Note {
    std::string what;
    std::vector<std::string> objects;  ///< the first of them
    size_t count = 0;
  };
  std::vector<Note> notes_;
};

}  // namespace slicefarm::slicing::threemf
