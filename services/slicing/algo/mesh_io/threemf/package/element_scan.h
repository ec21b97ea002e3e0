#pragma once

#include <string_view>
#include <vector>

#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

namespace slicefarm::slicing::threemf {

/// What the text is that comes next in a run of equal elements.
enum class ScanEnd {
  kElement,  ///< one of them, as a whole
  kMore,     ///< perhaps the beginning of one: more text is needed to tell
  kOther,    ///< anything else
};

/// Takes elements like `<vertex x="1" y="2" z="3"/>` off the front of a text, one by one, which is
/// many times faster than an XML parser. It knows only this one form, in ASCII and without
/// references, and stops at whatever is not in it; so what it takes is what any parser would.
class ElementScan {
 public:
  /// `name`: the element, with its prefix if it has one.
  ElementScan(std::string_view text, std::string_view name) : rest_(text), name_(name) {}

  /// Goes past white space and, if there is one, the next element.
  ScanEnd Next();

  /// Of the element that Next went past.
  XmlAttributes attributes() const { return attributes_; }
  /// What is still to come. Before an element that is not there as a whole.
  std::string_view rest() const { return rest_; }
  /// Line ends in what was passed.
  int64_t lines() const { return lines_; }

 private:
  void SkipSpace();
  ScanEnd Attributes(const char* at, const char* end);

  std::string_view rest_;
  std::string_view name_;
  std::vector<XmlAttribute> attributes_;
  int64_t lines_ = 0;
};

}  // namespace slicefarm::slicing::threemf
