#pragma once

#include <compare>
#include <string>
#include <vector>

namespace slicefarm::config {

/// Note for the report about a given setting without effect or without full effect.
struct SettingNote {
  /// Reason for a note that later steps act on.
  enum class Why {
    kOther,
    kUnmetNeed,   ///< another setting disables the setting
    kOverridden,  ///< the same source gives the setting again
  };

  std::string text = {};  ///< text for the user: `key = value: why`
  std::string key = {};   ///< name of the setting; may be empty if `why` is kOther
  Why why = Why::kOther;

  auto operator<=>(const SettingNote&) const = default;
};

/// Returns the texts of the notes.
inline std::vector<std::string> TextsOf(const std::vector<SettingNote>& notes) {
  std::vector<std::string> texts;
  for (const SettingNote& note : notes) texts.push_back(note.text);
  return texts;
}

/// Puts notes with these texts in front of the other notes.
inline void PutInFront(const std::vector<std::string>& texts, std::vector<SettingNote>& notes) {
  std::vector<SettingNote> front;
  for (const std::string& text : texts) front.push_back({text});
  notes.insert(notes.begin(), front.begin(), front.end());
}

}  // namespace slicefarm::config
