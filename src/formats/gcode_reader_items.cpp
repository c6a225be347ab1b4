#include <algorithm>
#include <string>

#include "formats/gcode_number.h"
#include "formats/gcode_reader_class.h"

/// What the lines become, and what is said about them.
namespace unstep {

/// An item with the state of this moment.
ProgramItem GcodeReader::item(Kind kind) {
  ProgramItem made;
  made.kind = kind;
  made.mode = state_.mode;
  made.known = state_.known;
  made.line = line_;
  made.feed = state_.feed;
  made.spindle = state_.spindle;
  std::copy_n(state_.position.begin(), 3, made.end.begin());
  if (program_.modes.back() != state_.modes) {
    program_.modes.push_back(state_.modes);
  }
  made.modes = static_cast<std::uint32_t>(program_.modes.size() - 1);
  if (!std::equal(program_.others.back().begin(), program_.others.back().end(),
                  state_.position.begin() + 3)) {
    std::copy_n(state_.position.begin() + 3, kProgramAxes - 3,
                program_.others.emplace_back().begin());
  }
  made.others = static_cast<std::uint32_t>(program_.others.size() - 1);
  return made;
}

bool GcodeReader::add(ProgramItem made) {
  if (!within_memory()) return false;
  program_.items.push_back(made);
  return true;
}

/// Vectors may hold twice what they need, and both sizes while they grow.
bool GcodeReader::within_memory() {
  const std::uint64_t memory =
      program_.text.size() +
      3 * (program_.items.size() * sizeof(ProgramItem) +
           program_.modes.size() * sizeof(ProgramModes) +
           program_.others.size() * sizeof(ProgramOtherAxes));
  if (memory <= options_.limits.max_memory) return true;
  return fail(ErrorCode::limit_exceeded,
              "more than the memory limit of " +
                  std::to_string(options_.limits.max_memory) + " bytes");
}

/// The words of a line with their numbers instead of parameters, whose values
/// are others where loops and calls are gone.
std::string GcodeReader::evaluated_line() const {
  std::string out;
  const auto put = [&out](char letter, std::int64_t number) {
    if (!out.empty()) out += ' ';
    out += letter;
    append_number(out, number);
  };
  constexpr std::int64_t kTenth = kGcodeNumberScale / 10;
  for (std::size_t i = 0; i < block_.g_count; ++i) {
    put('G', block_.g[i] * kTenth);
  }
  for (std::size_t i = 0; i < block_.m_count; ++i) {
    put('M', block_.m[i] * kTenth);
  }
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (letter == 'N') continue;
    if (block_.has(letter)) put(letter, block_.at(letter));
    if ((block_.flags & letter_bit(letter)) != 0) {
      out += ' ';
      out += letter;
    }
  }
  for (const auto& [begin, size] : block_.comments) {
    if (!out.empty()) out += ' ';
    out += text_.substr(begin_ + begin, size);
  }
  return out;
}

/// A line's number and checksum are of no use among other lines.
void GcodeReader::give_text(ProgramItem& made) {
  if (follows_ && block_.computed) {
    const std::string line = evaluated_line();
    made.text_begin = program_.text.size();
    made.text_size = static_cast<std::uint32_t>(line.size());
    program_.text += line;
    return;
  }
  std::size_t begin = begin_;
  std::size_t end = begin_ + block_.body_end;
  if (block_.body_end < program_.text.size() - begin_ &&
      program_.text[end] == '*') {
    begin += block_.body_begin;
  }
  while (begin < end && program_.text[begin] == ' ') ++begin;
  while (begin < end && program_.text[end - 1] == ' ') --end;
  made.text_begin = begin;
  made.text_size = static_cast<std::uint32_t>(end - begin);
}

bool GcodeReader::add_text(bool unknown_effect) {
  const bool only_assigns = block_.assigns && block_.values == 0 &&
                            block_.flags == 0 && block_.g_count == 0 &&
                            block_.m_count == 0 && block_.comments.empty();
  if (follows_ && only_assigns) return true;
  ProgramItem made = item(Kind::text);
  made.unknown_effect = unknown_effect;
  made.names_mode = names_mode_;
  made.ends_program = ended_;
  give_text(made);
  return add(made);
}

bool GcodeReader::add_comments() {
  for (const auto& [begin, size] : block_.comments) {
    ProgramItem comment =
        program_.items.empty() ? program_.start : program_.items.back();
    comment.kind = Kind::text;
    comment.keep_text = comment.unknown_effect = false;
    comment.line = line_;
    comment.words = 0;
    comment.names_mode = comment.ends_program = false;
    comment.text_begin = begin_ + begin;
    comment.text_size = size;
    if (!add(comment)) return false;
  }
  return true;
}

/// False if the options refuse it.
bool GcodeReader::not_understood(const std::string& what) {
  if (options_.strict) {
    return fail(ErrorCode::unsupported, what + " is not understood");
  }
  const auto found =
      std::find_if(notes_.begin(), notes_.end(),
                   [&what](const Note& note) { return note.reason == what; });
  if (found != notes_.end()) {
    ++found->count;
  } else if (notes_.size() < 100) {
    notes_.push_back({what, line_, 1});
  }
  return true;
}

bool GcodeReader::add_unknown(const std::string& what) {
  if (!not_understood(what)) return false;
  state_.forget();
  return add_text(true);
}

}  // namespace unstep
