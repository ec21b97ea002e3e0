#pragma once

#include <map>
#include <string>
#include <string_view>

#include "common/config/draft.h"

namespace slicefarm::config {

/// What a job was given and no stage works with, by key, each value on one line as a config.ini
/// writes it. Profiles ask for it in their G-code (`{if printer_notes=~/.*MK3S.*/}`), and files
/// quote it.
using ToldSettings = std::map<std::string, std::string, std::less<>>;

/// Adds `key = value` to `told`, where there is anything to tell: not if the key is none that a
/// template could name, or one that known_keys.h keeps back. Control characters become spaces.
void Tell(std::string_view key, std::string_view value, ToldSettings& told);

/// Adds the settings of `draft` that were given another value than their standard and work through
/// others only, `extrusion_width` say.
void TellDerived(const Draft& draft, ToldSettings& told);

/// The lines `key = value` of `text` whose keys `code`, G-code with placeholders, mentions. More
/// than it needs rather than fewer: any word counts, wherever it stands.
std::string LinesNamedIn(std::string_view code, std::string_view text);

}  // namespace slicefarm::config
