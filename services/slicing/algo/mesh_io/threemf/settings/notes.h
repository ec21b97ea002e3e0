#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace slicefarm::slicing::threemf {

/// Notes about ignored features and their objects: "painted filaments of `a`, `b` and 3 more".
class Notes {
 public:
  /// Adds `object`, the name of an object, to the note `what`. An empty `object` means that the
  /// note is about the file.
  void Add(std::string_view what, std::string_view object);
  /// Returns one line for each `what`, in the order of their first Add.
  std::vector<std::string> Lines() const;

 private:
  struct Note {
    std::string what;
    /// names of the first objects; further objects are only counted
    std::vector<std::string> objects;
    size_t count = 0;
  };
  std::vector<Note> notes_;
};

}  // namespace slicefarm::slicing::threemf
