#include "processes/fdm/job/fdm_programs.h"

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/model/limits.h"
#include "processes/fdm/job/layer_pieces.h"

namespace slicefarm::coordinator {
namespace {

bool IsEmpty(const LayerProgram& program) { return program.stats.ExtrudedMm() == 0; }

absl::Status CheckPrograms(const std::vector<SpooledProgram>& programs, size_t layer_count) {
  int32_t next = 0;
  int32_t pass = -1;
  for (const SpooledProgram& spooled : programs) {
    const int32_t index = spooled.program.frame.index;
    const bool next_pass = index == next - 1 && spooled.program.pass > pass;
    if (index != next && !next_pass)
      return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                       absl::StrCat("layer ", next, " came back as ", index));
    next = index + 1;
    pass = spooled.program.pass;
  }
  if (next == static_cast<int32_t>(layer_count)) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                   absl::StrCat(next, " of ", layer_count, " layers came back"));
}

/// Removes empty layers at the top of each pass. An object that ends between two slicing planes may
/// have top outlines that are too small for a bead. A pass ends with the last layer that has beads;
/// empty layers below it remain. Errors: InvalidArgument (NOTHING_TO_PRINT) if no layer has beads.
absl::Status DropEmptyTops(std::vector<SpooledProgram>& programs) {
  std::vector<SpooledProgram> kept;
  std::map<int32_t, size_t> last;  // last layer with beads, by pass
  for (size_t i = 0; i < programs.size(); ++i)
    if (!IsEmpty(programs[i].program)) last[programs[i].program.pass] = i;
  for (size_t i = 0; i < programs.size(); ++i) {
    const auto end = last.find(programs[i].program.pass);
    if (end != last.end() && i <= end->second) kept.push_back(std::move(programs[i]));
  }
  programs = std::move(kept);
  if (!programs.empty()) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                   "no layer contains an extrusion: the outlines are too thin, or perimeters, "
                   "fill_density and the numbers of solid layers are 0");
}

LayerSummary Summarize(const LayerProgram& program) {
  return {.frame = program.frame,
          .pass = program.pass,
          .entry = program.entry,
          .exit = program.exit,
          .time_s = program.stats.TimeS(),
          .empty = IsEmpty(program),
          .edges = program.edges,
          .filament_mm = program.stats.FilamentMm(),
          .footprint = program.footprint,
          .silent_time_s = program.silent_time_s};
}

/// Appends the pieces of a layer to `gcode` without reading the program from the spool.
void AddLayer(const SpooledProgram& layer, std::vector<LayerPiece> pieces, SpooledText& gcode) {
  for (LayerPiece& piece : pieces) {
    gcode.Add(SpoolFile::Chunk{layer.text.offset + piece.first, piece.last - piece.first});
    if (!piece.text.empty()) gcode.Add(std::move(piece.text));
  }
}

/// Returns a prefix and the pieces of a layer as one text.
absl::StatusOr<std::string> TextOf(const SpooledProgram& layer, std::string_view prefix,
                                   std::span<const LayerPiece> pieces, const SpoolFile& spool) {
  std::string program(static_cast<size_t>(layer.text.size), '\0');
  if (absl::Status read = spool.ReadAt(layer.text.offset, program); !read.ok()) return read;
  std::string text(prefix);
  for (const LayerPiece& piece : pieces)
    text.append(program, static_cast<size_t>(piece.first),
                static_cast<size_t>(piece.last - piece.first))
        .append(piece.text);
  return text;
}

/// Returns `text` after the substitutions. The result may have twice the size plus
/// limits::kMaxExpandedBytes.
absl::StatusOr<std::string> Substituted(std::string text, const gcode::Substitutions& substitutions,
                                        const CancelToken& cancel) {
  const size_t most = 2 * text.size() + limits::kMaxExpandedBytes;
  auto substituted = substitutions.Apply(std::move(text), most, cancel);
  if (!absl::IsResourceExhausted(substituted.status())) return substituted;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestTooLarge,
                   absl::StrCat("gcode_substitutions: ", substituted.status().message(),
                                ", more than twice the original text"),
                   {{"setting", "gcode_substitutions"}, {"limit", absl::StrCat(most)}});
}

/// Returns the number of retractions that a program omits when it follows a layer that ends
/// retracted. `retracted`: the layer below ends retracted.
int64_t LeftOutAfter(bool retracted, const LayerProgram& program) {
  if (!retracted) return 0;
  return std::ranges::count_if(program.mode_lines, [](const ModeLine& line) {
    return line.mode == MachineMode::kFilament && line.value == kRetracted;
  });
}

}  // namespace

absl::StatusOr<std::vector<SpooledProgram>> Spooled(std::vector<LayerProgram> programs,
                                                    SpoolFile& spool) {
  std::vector<SpooledProgram> spooled;
  spooled.reserve(programs.size());
  for (LayerProgram& program : programs) {
    const auto chunk = spool.Add(program.gcode);
    if (!chunk.ok()) return chunk.status();
    std::string().swap(program.gcode);
    spooled.push_back({std::move(program), *chunk});
  }
  return spooled;
}

absl::StatusOr<std::vector<SpooledProgram>> InPrintOrder(std::vector<SpooledProgram> programs,
                                                         size_t layer_count) {
  if (absl::Status whole = CheckPrograms(programs, layer_count); !whole.ok()) return whole;
  std::ranges::stable_sort(programs, {},
                           [](const SpooledProgram& spooled) { return spooled.program.pass; });
  if (absl::Status printable = DropEmptyTops(programs); !printable.ok()) return printable;
  return programs;
}

ProgramSummary Summarize(const std::vector<SpooledProgram>& programs) {
  ProgramSummary summary;
  bool retracted = true;
  for (const SpooledProgram& spooled : programs) {
    summary.layers.push_back(Summarize(spooled.program));
    summary.total.Add(spooled.program.stats);
    summary.total.retractions -= LeftOutAfter(retracted, spooled.program);
    retracted = spooled.program.ends_retracted;
  }
  return summary;
}

absl::Status AddCopyUses(const std::vector<SpooledProgram>& programs,
                         std::vector<CopySummary>& copies) {
  for (const SpooledProgram& spooled : programs)
    for (const CopyUse& copy : spooled.program.copies) {
      const auto index = static_cast<size_t>(copy.copy);
      if (index >= copies.size())
        return MakeError(absl::StatusCode::kInternal, Reason::kInternal,
                         absl::StrCat("layer ", spooled.program.frame.index,
                                      " came back with copy ", copy.copy, " of ", copies.size()));
      copies[index].use.Add(copy.use);
    }
  return absl::OkStatus();
}

absl::StatusOr<SpooledText> WholeProgram(ProgramEnvelope frame,
                                         const std::vector<SpooledProgram>& programs,
                                         const gcode::Substitutions& substitutions,
                                         std::unique_ptr<SpoolFile> spool,
                                         const CancelToken& cancel) {
  SpoolFile& file = *spool;
  SpooledText gcode(std::move(spool));
  gcode.Add(std::move(frame.head));
  auto prologue = Substituted(std::move(frame.prologue), substitutions, cancel);
  if (!prologue.ok()) return prologue.status();
  gcode.Add(*std::move(prologue));
  frame.layer_prefixes.resize(programs.size());
  LayerJoin join;
  for (size_t i = 0; i < programs.size(); ++i) {
    const size_t first = std::min(i * kCodesOfALayer, frame.layer_code.size());
    const size_t count = std::min<size_t>(kCodesOfALayer, frame.layer_code.size() - first);
    join.Pass(frame.layer_prefixes[i]);
    auto pieces = join.PiecesOf(programs[i].program, programs[i].text.size,
                                std::span(frame.layer_code).subspan(first, count));
    if (substitutions.empty()) {
      gcode.Add(std::move(frame.layer_prefixes[i]));
      AddLayer(programs[i], std::move(pieces), gcode);
      continue;
    }
    auto text = TextOf(programs[i], frame.layer_prefixes[i], pieces, file);
    if (!text.ok()) return text.status();
    auto substituted = Substituted(*std::move(text), substitutions, cancel);
    if (!substituted.ok()) return substituted.status();
    const auto chunk = file.Add(*substituted);
    if (!chunk.ok()) return chunk.status();
    gcode.Add(*chunk);
    if (gcode.size() > limits::kMaxProgramBytes)
      return LimitError(Reason::kRequestTooLarge, "bytes of the program after gcode_substitutions",
                        limits::kMaxProgramBytes, gcode.size());
  }
  auto epilogue = Substituted(std::move(frame.epilogue), substitutions, cancel);
  if (!epilogue.ok()) return epilogue.status();
  gcode.Add(*std::move(epilogue));
  gcode.Add(std::move(frame.tail));
  return gcode;
}

}  // namespace slicefarm::coordinator
