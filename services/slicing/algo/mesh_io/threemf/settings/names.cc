#include "services/slicing/algo/mesh_io/threemf/settings/names.h"

#include "common/base/text.h"
#include "common/base/utf8.h"
#include "common/model/limits.h"

namespace slicefarm::slicing::threemf {

std::string CleanName(std::string_view text) {
  const std::string clean = ReplaceControls(ToUtf8(text, limits::kMaxNameBytes), ' ');
  return std::string(Trim(clean));
}

std::string EscapedText(std::string_view text) {
  std::string escaped;
  for (const char c : ToUtf8(text, text.size())) {
    if (c == '\n')
      escaped += "\\n";
    else if (c == '\r')
      escaped += "\\r";
    else if (c == '\\')
      escaped += "\\\\";
    else if (!IsControl(c) || c == '\t')
      escaped += c;
  }
  return escaped;
}

}  // namespace slicefarm::slicing::threemf
