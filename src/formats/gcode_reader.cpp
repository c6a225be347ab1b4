#include <algorithm>
#include <new>
#include <string>
#include <utility>

#include "formats/gcode_reader_class.h"

/// Lines of G-code to items. docs/cnc.md says what each word does.
namespace unstep {

GcodeReader::GcodeReader(std::string_view text, const GcodeReadOptions& options)
    : options_(options),
      text_(text),
      lines_(options.execute_flow),
      flow_(text) {
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
  // Not program_.text, which grows where lines are evaluated.
  const std::string_view text = text_;
  next_ = {text.starts_with("\xef\xbb\xbf") ? std::size_t{3} : 0, 1};
  while (next_.at < text.size() && !(ended_ && follows_)) {
    begin_ = next_.at;
    line_ = next_.line;
    const std::size_t newline = std::min(text.find('\n', begin_), text.size());
    next_ = {newline + 1, line_ + 1};
    if (newline - begin_ > options_.limits.max_line_bytes) {
      return error(ErrorCode::limit_exceeded,
                   "longer than the limit of " +
                       std::to_string(options_.limits.max_line_bytes) +
                       " bytes");
    }
    std::size_t end = newline;
    while (end > begin_ && (text[end - 1] == '\r' || text[end - 1] == ' ' ||
                            text[end - 1] == '\t')) {
      --end;
    }
    if (follows_ && !count_line()) return error_;
    if (!run_line(text.substr(begin_, end - begin_))) return error_;
  }
  if (!ended_) {
    if (Status closed = flow_.finish(); !closed) return closed.error();
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
  if (ended_ || flow_kept_) {
    block_.comments.clear();
    block_.body_begin = 0;
    block_.body_end = static_cast<std::uint32_t>(line.size());
    return line.empty() || add_text(flow_kept_ && !ended_);
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
  if (optional_line) {
    if ((block_.kind == GcodeBlock::Kind::o_flow && options_.execute_flow) ||
        (follows_ && block_.computed)) {
      return refuse_flow("control flow that \"/\" may leave out");
    }
    return add_unknown("\"/\" may leave the line out");
  }
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
      if (options_.execute_flow) return run_flow();
      flow_kept_ = true;
      return add_unknown("control flow, and all that follows it");
    case GcodeBlock::Kind::words: return run_words();
  }
  return true;
}

bool GcodeReader::run_words() {
  LineCodes codes;
  if (!sort_codes(codes)) return false;
  if (follows_ && (block_.unknown_value || block_.assigns_offset)) {
    return refuse_flow(
        "control flow around parameters that the control has or gets");
  }
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

bool GcodeReader::run_flow() {
  follows_ = true;
  const Result<GcodePlace> next =
      flow_.run(block_.flow, {begin_, line_}, next_, lines_.parameters());
  if (!next) {
    const Error& error = next.error();
    return error.code == ErrorCode::unsupported
               ? refuse_flow(error.message)
               : fail(error.code, error.message);
  }
  next_ = *next;
  return true;
}

bool GcodeReader::refuse_flow(const std::string& reason) {
  flow_failed_ = true;
  return fail(ErrorCode::unsupported, reason + " is not understood");
}

bool GcodeReader::count_line() {
  const std::uint64_t most = options_.limits.max_executed_lines;
  if (++executed_ <= most) return true;
  return fail(ErrorCode::limit_exceeded,
              "more than the limit of " + std::to_string(most) +
                  " lines carried out: a loop may have no end");
}

Result<Program> read_gcode(std::string_view text,
                           const GcodeReadOptions& options) {
  try {
    GcodeReader reader(text, options);
    Result<Program> program = reader.read();
    if (program || options.strict || !reader.flow_failed()) return program;
    GcodeReadOptions kept = options;
    kept.execute_flow = false;
    const std::string reason = program.error().message;
    program = GcodeReader(text, kept).read();
    if (program) program->notes.push_back(reason);
    return program;
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit_exceeded, "no memory for the program"};
  }
}

}  // namespace unstep
