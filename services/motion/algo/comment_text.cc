#include "services/motion/algo/comment_text.h"

#include <algorithm>

#include "common/model/text.h"

namespace slicefarm::motion {

std::string OneLine(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '\n':
        line += "\\n";
        break;
      case '\r':
        line += "\\r";
        break;
      case '\\':
        line += "\\\\";
        break;
      default:
        line += IsControl(c) ? ' ' : c;
    }
  }
  return line;
}

std::string CommentLine(std::string_view line) {
  std::string safe(line);
  std::replace_if(safe.begin(), safe.end(), IsControl, ' ');
  return safe;
}

std::string JsonString(std::string_view text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    json += IsControl(c) ? ' ' : c;
  }
  return json + '"';
}

}  // namespace slicefarm::motion
