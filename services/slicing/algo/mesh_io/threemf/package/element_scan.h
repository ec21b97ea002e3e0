#pragma once

#include <string_view>
#include <vector>

#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

namespace slicefarm::slicing::threemf {

/// Result of ElementScan::Next: the kind of text that is next.
enum class ScanEnd {
  kElement,  ///< one complete element of this name
  kMore,     ///< perhaps the beginning of an element of this name; more text is needed to decide
  kOther,    ///< anything else
};

/// Scanner that removes elements like `<vertex x="1" y="2" z="3"/>` from the front of a text, one
/// by one. This is many times faster than an XML parser.
///
/// It supports only this one form, in ASCII and without references, and stops at anything else. So
/// any XML parser would read the same elements.
class ElementScan {
 public:
  /// `name`: name of the element, with its prefix if it has one.
  ElementScan(std::string_view text, std::string_view name) : rest_(text), name_(name) {}

  /// Skips white space and removes the next element, if there is one.
  ScanEnd Next();

  /// Returns the attributes of the element that Next has removed.
  XmlAttributes attributes() const { return attributes_; }
  /// Returns the remaining text. If it begins with an incomplete element, this element is still in
  /// it.
  std::string_view rest() const { return rest_; }
  /// Returns the number of line ends in the scanned text.
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
