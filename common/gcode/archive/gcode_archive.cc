#include "common/gcode/archive/gcode_archive.h"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "common/base/text.h"
#include "common/gcode/archive/plate_texts.h"
#include "common/gcode/archive/zip_bytes.h"

namespace slicefarm::gcode {
namespace {

constexpr std::string_view kProgramBegin = "Metadata/plate_", kProgramEnd = ".gcode";
constexpr std::string_view kSliceInfo = "Metadata/slice_info.config";
constexpr std::string_view kModelSettings = "Metadata/model_settings.config";
constexpr std::string_view kModelRelations = "Metadata/_rels/model_settings.config.rels";
constexpr std::string_view kProjectSettings = "Metadata/project_settings.config";
constexpr std::string_view kModel = "3D/3dmodel.model";

/// Returns the MD5 as printers expect it: upper case, without a line end.
std::string Md5Of(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest = {};
  unsigned int size = 0;
  EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_md5(), nullptr);
  std::string hex;
  for (unsigned int i = 0; i < size; ++i) hex += fmt::format("{:02X}", digest[i]);
  return hex;
}

std::string Numbered(const std::string& name, int number) {
  return absl::StrReplaceAll(name, {{"#", std::to_string(number)}});
}

std::string ProgramName(int plate) {
  return fmt::format("{}{}{}", kProgramBegin, plate, kProgramEnd);
}

/// Returns the files of one plate.
std::vector<ZipMember> FilesOf(const ArchivedPlate& plate, int number) {
  std::vector<ZipMember> files;
  for (const ArchivedPicture& picture : plate.pictures)
    files.push_back({"Metadata/" + Numbered(picture.name, number), picture.png, false});
  files.push_back({fmt::format("{}{}.json", kProgramBegin, number), PlateJson(plate)});
  files.push_back({ProgramName(number) + ".md5", Md5Of(plate.gcode)});
  files.push_back({ProgramName(number), plate.gcode});
  return files;
}

/// Texts that describe all plates.
struct PlateElements {
  int count = 0;
  std::string slice_info;
  std::string model_settings;
};

/// Returns the files of an archive: the pictures of the plates, the other files of the plates, and
/// the files about all plates. The pictures are first, so that the first bytes contain them.
std::vector<ZipMember> WholeArchive(std::vector<ZipMember> of_plates, std::string model,
                                    std::string project_settings, const PlateElements& elements) {
  std::vector<ZipMember> files = {{"[Content_Types].xml", ContentTypesDocument()}};
  std::stable_partition(of_plates.begin(), of_plates.end(),
                        [](const ZipMember& file) { return !file.deflated; });
  std::ranges::move(of_plates, std::back_inserter(files));
  files.push_back({std::string(kModel), std::move(model)});
  files.push_back({std::string(kProjectSettings), std::move(project_settings)});
  files.push_back({std::string(kModelRelations), ModelSettingsRelations(elements.count)});
  files.push_back({std::string(kModelSettings), ModelSettingsDocument(elements.model_settings)});
  files.push_back({std::string(kSliceInfo), SliceInfoDocument(elements.slice_info)});
  files.push_back({"_rels/.rels", RelationsDocument()});
  return files;
}

/// Returns the number of the plate of which a file is the program; nullopt for other files.
std::optional<int> PlateOfProgram(std::string_view name) {
  if (!name.starts_with(kProgramBegin) || !name.ends_with(kProgramEnd)) return std::nullopt;
  name.remove_prefix(kProgramBegin.size());
  name.remove_suffix(std::min(name.size(), kProgramEnd.size()));
  int number = 0;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr == name.data() + name.size();
  return whole && number > 0 ? std::optional(number) : std::nullopt;
}

const ZipEntryInfo* FindEntry(const std::vector<ZipEntryInfo>& entries, std::string_view name) {
  const auto found = std::ranges::find(entries, name, &ZipEntryInfo::name);
  return found == entries.end() ? nullptr : &*found;
}

absl::StatusOr<std::string> DataOf(std::string_view archive,
                                   const std::vector<ZipEntryInfo>& entries,
                                   std::string_view name) {
  const ZipEntryInfo* entry = FindEntry(entries, name);
  if (entry == nullptr)
    return absl::InvalidArgumentError(fmt::format("the archive has no file {}", name));
  return ZipData(archive, *entry);
}

std::vector<int> PlatesIn(const std::vector<ZipEntryInfo>& entries) {
  std::vector<int> plates;
  for (const ZipEntryInfo& entry : entries)
    if (const auto plate = PlateOfProgram(entry.name)) plates.push_back(*plate);
  std::ranges::sort(plates);
  plates.erase(std::unique(plates.begin(), plates.end()), plates.end());
  return plates;
}

absl::Status NoProgram() {
  return absl::InvalidArgumentError(
      "the archive has no program (Metadata/plate_N.gcode): a project must be sliced first");
}

absl::StatusOr<int> ChosenPlate(const std::vector<int>& plates, int wanted) {
  if (plates.empty()) return NoProgram();
  const bool several = plates.size() > 1;
  if (wanted == kFirstPlate || (wanted == kOnlyPlate && !several)) return plates.front();
  if (std::ranges::binary_search(plates, wanted)) return wanted;
  return absl::InvalidArgumentError(fmt::format(
      "the archive has {} {}{}", several ? "the plates" : "only plate", absl::StrJoin(plates, ", "),
      wanted == kOnlyPlate ? ": choose one with --plate N"
                           : fmt::format(", but no plate {}", wanted)));
}

/// Returns the element `<plate>` of a document that GcodeArchive made, with another number.
absl::StatusOr<std::string> PlateElement(std::string_view document, int number) {
  constexpr std::string_view kBegin = "  <plate>\n", kEnd = "  </plate>\n";
  const size_t begin = document.find(kBegin);
  const size_t end = begin == document.npos ? begin : document.find(kEnd, begin);
  if (end == document.npos || document.find(kBegin, end) != document.npos)
    return absl::InvalidArgumentError("the archive does not have exactly one plate of slicefarm");
  return absl::StrReplaceAll(
      std::string(document.substr(begin, end + kEnd.size() - begin)),
      {{"key=\"index\" value=\"1\"", fmt::format("key=\"index\" value=\"{}\"", number)},
       {"key=\"plater_id\" value=\"1\"", fmt::format("key=\"plater_id\" value=\"{}\"", number)},
       {"Metadata/plate_1.", fmt::format("Metadata/plate_{}.", number)},
       {"Metadata/plate_no_light_1.", fmt::format("Metadata/plate_no_light_{}.", number)},
       {"Metadata/top_1.", fmt::format("Metadata/top_{}.", number)},
       {"Metadata/pick_1.", fmt::format("Metadata/pick_{}.", number)}});
}

/// Returns the name of a file of plate 1 with another number; nullopt for files about all plates.
std::optional<std::string> Renumbered(std::string_view name, int number) {
  constexpr std::string_view kBegins[] = {"Metadata/plate_1", "Metadata/plate_no_light_1",
                                          "Metadata/top_1", "Metadata/pick_1"};
  for (const std::string_view begin : kBegins) {
    if (!name.starts_with(begin)) continue;
    return fmt::format("{}{}{}", begin.substr(0, begin.size() - 1), number,
                       name.substr(begin.size()));
  }
  return std::nullopt;
}

/// Adds the files and elements of an archive with one plate.
absl::Status AddPlate(std::string_view archive, int number, std::vector<ZipMember>& files,
                      PlateElements& elements) {
  const auto entries = ZipEntries(archive);
  if (!entries.ok()) return entries.status();
  if (FindEntry(*entries, ProgramName(1)) == nullptr) return NoProgram();
  for (const ZipEntryInfo& entry : *entries) {
    auto name = Renumbered(entry.name, number);
    if (!name) continue;
    auto data = ZipData(archive, entry);
    if (!data.ok()) return data.status();
    const bool picture = name->ends_with(".png");
    files.push_back({*std::move(name), *std::move(data), !picture});
  }
  ++elements.count;
  for (const auto& [name, text] : {std::pair(kSliceInfo, &elements.slice_info),
                                   std::pair(kModelSettings, &elements.model_settings)}) {
    const auto document = DataOf(archive, *entries, name);
    if (!document.ok()) return document.status();
    const auto element = PlateElement(*document, number);
    if (!element.ok()) return element.status();
    *text += *element;
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::string> GcodeArchive(const std::vector<ArchivedPlate>& plates) {
  std::vector<ZipMember> files;
  PlateElements elements;
  for (const ArchivedPlate& plate : plates) {
    const int number = ++elements.count;
    std::ranges::move(FilesOf(plate, number), std::back_inserter(files));
    elements.slice_info += SliceInfoPlate(plate, number);
    elements.model_settings += ModelSettingsPlate(number, plate.title);
  }
  const ArchivedPlate& first = plates.front();
  return ZipOf(WholeArchive(std::move(files), ModelDocument(first.title),
                            ProjectSettingsJson(first), elements));
}

bool IsGcodeArchive(std::string_view file) { return file.starts_with("PK\x03\x04"); }

absl::StatusOr<std::vector<int>> PlatesOf(std::string_view archive) {
  const auto entries = ZipEntries(archive);
  if (!entries.ok()) return entries.status();
  std::vector<int> plates = PlatesIn(*entries);
  if (plates.empty()) return NoProgram();
  return plates;
}

absl::StatusOr<std::string> TextOfPlate(std::string_view archive, int plate) {
  const auto entries = ZipEntries(archive);
  if (!entries.ok()) return entries.status();
  const auto chosen = ChosenPlate(PlatesIn(*entries), plate);
  if (!chosen.ok()) return chosen.status();
  const std::string name = ProgramName(*chosen);
  auto text = DataOf(archive, *entries, name);
  if (!text.ok() || FindEntry(*entries, name + ".md5") == nullptr) return text;
  const auto md5 = DataOf(archive, *entries, name + ".md5");
  if (!md5.ok()) return md5.status();
  if (absl::AsciiStrToUpper(std::string(Trim(*md5))) == Md5Of(*text)) return text;
  return absl::InvalidArgumentError(
      fmt::format("{} in the archive does not match its MD5 checksum", name));
}

absl::StatusOr<std::string> JoinedArchive(const std::vector<std::string>& archives) {
  std::vector<ZipMember> files;
  PlateElements elements;
  for (const std::string& archive : archives)
    if (absl::Status added = AddPlate(archive, elements.count + 1, files, elements); !added.ok())
      return added;
  if (archives.empty()) return NoProgram();
  const auto entries = ZipEntries(archives.front());
  if (!entries.ok()) return entries.status();
  auto model = DataOf(archives.front(), *entries, kModel);
  if (!model.ok()) return model.status();
  auto settings = DataOf(archives.front(), *entries, kProjectSettings);
  if (!settings.ok()) return settings.status();
  return ZipOf(WholeArchive(std::move(files), *std::move(model), *std::move(settings), elements));
}

}  // namespace slicefarm::gcode
