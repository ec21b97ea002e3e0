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
  const std::string clean = ToUtf8(text, text.size());
  std::string escaped;
  for (size_t i = 0; i < clean.size(); ++i) {
    const char c = clean[i];
    const bool last = i + 1 == clean.size();
    if (c == '\n')
      escaped += "\\n";
    else if (c == '\r')
      escaped += "\\r";
    else if (c == '\\' && last)
      escaped += "\\\\";
    else if (c == '\\' && !IsControl(clean[i + 1]))
      escaped += {c, clean[++i]};
    else if (c != '\\' && (!IsControl(c) || c == '\t'))
      escaped += c;
  }
  return escaped;
}

}  // namespace slicefarm::slicing::threemf
