#include <algorithm>
#include <new>
#include <string>
#include <utility>

#include "formats/gcode_reader_class.h"

/// Lines of G-code to items. docs/cnc.md says what each word does.
namespace unstep {

GcodeReader::GcodeReader(std::string_view text, const GcodeReadOptions& options)
    : options_(options) {
  program_.text = text;
  ProgramModes& modes = state_.modes;
  modes.inches = options.inches;
  modes.incremental = modes.absolute_centres = modes.incremental_e = false;
  modes.plane = ProgramPlane::xy;
  modes.per_minute = true;
  modes.compensated = false;
  program_.modes[0] = modes;
  program_.start = item(Kind::text);
}

Result<Program> GcodeReader::read() {
  if (program_.text.size() > options_.limits.max_bytes) {
    return Error{ErrorCode::limit_exceeded,
                 "more than the limit of " +
                     std::to_string(options_.limits.max_bytes) + " bytes"};
  }
  const std::string_view text = program_.text;
  std::size_t at = text.starts_with("\xef\xbb\xbf") ? 3 : 0;
  while (at < text.size()) {
    const std::size_t newline = std::min(text.find('\n', at), text.size());
    std::size_t end = newline;
    ++line_;
    if (end - at > options_.limits.max_line_bytes) {
      return error(ErrorCode::limit_exceeded,
                   "longer than the limit of " +
                       std::to_string(options_.limits.max_line_bytes) +
                       " bytes");
    }
    while (end > at && (text[end - 1] == '\r' || text[end - 1] == ' ' ||
                        text[end - 1] == '\t')) {
      --end;
    }
    begin_ = at;
    if (!run_line(text.substr(at, end - at))) return error_;
    at = newline + 1;
  }
  for (const Note& note : notes_) {
    std::string message = "line " + std::to_string(note.line);
    if (note.count > 1) {
      message += " and " + std::to_string(note.count - 1) + " more";
    }
    program_.notes.push_back(message + ": " + note.reason +
                             ": kept as it stands");
  }
  return std::move(program_);
}

bool GcodeReader::run_line(std::string_view line) {
  if (ended_ || flow_) {
    block_.comments.clear();
    block_.body_begin = 0;
    block_.body_end = static_cast<std::uint32_t>(line.size());
    return line.empty() || add_text(flow_ && !ended_);
  }
  names_mode_ = false;
  const Status read = lines_.read(line, block_);
  if (!read) return fail(read.error().code, read.error().message);
  using BlockDelete = GcodeReadOptions::BlockDelete;
  const bool optional_line =
      block_.deleted && options_.block_delete == BlockDelete::keep;
  const bool skipped =
      block_.deleted && options_.block_delete == BlockDelete::skip;
  if (!skipped) lines_.set_parameters(!optional_line);
  if (skipped) return true;
  const bool first = !started_;
  started_ = started_ || block_.kind != GcodeBlock::Kind::blank;
  if (optional_line) return add_unknown("\"/\" may leave the line out");
  switch (block_.kind) {
    case GcodeBlock::Kind::blank:
      if (block_.comments.empty() &&
          (program_.items.empty() || program_.items.back().is_motion())) {
        return true;
      }
      return add_text();
    case GcodeBlock::Kind::percent: ended_ = !first; return add_text();
    case GcodeBlock::Kind::command:
      return add_unknown("a command that is no G-code");
    case GcodeBlock::Kind::o_number: return add_text();
    case GcodeBlock::Kind::o_flow:
      flow_ = true;
      return add_unknown("control flow, and all that follows it");
    case GcodeBlock::Kind::words: return run_words();
  }
  return true;
}

bool GcodeReader::run_words() {
  LineCodes codes;
  if (!sort_codes(codes)) return false;
  if (block_.unknown_value) {
    return add_unknown("a parameter that the program does not set");
  }
  if (block_.assigns_offset) {
    return add_unknown("parameters of the control are set");
  }
  if (codes.unknown) return add_unknown(codes.unknown_word);
  if (!check_flags(codes)) return false;
  const bool plain = is_plain(codes);
  if (!apply_settings(codes)) return false;
  if (codes.motion >= 0 && !set_motion_mode(codes.motion)) return false;
  const std::uint32_t moving = kAxisLetters | kArcLetters;
  names_mode_ = codes.motion >= 0;
  ended_ = codes.end;
  bool done = false;
  if (codes.once >= 0) {
    bool unknown_effect = false;
    if (!apply_once(codes.once, unknown_effect)) return false;
    done = add_text(unknown_effect);
  } else if ((block_.values & moving) != 0) {
    done = run_motion(codes, plain);
  } else {
    done = add_text();
  }
  return done && in_range();
}

Result<Program> read_gcode(std::string_view text,
                           const GcodeReadOptions& options) {
  try {
    return GcodeReader(text, options).read();
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the program"};
  }
}

}  // namespace unstep
