#include "formats/svg_path_data.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "formats/decimal.h"
#include "formats/outline.h"

namespace unstep {

void SvgPathData::restart() {
  last_ = 0;
  separate_ = false;
  at_ = {};
}

void SvgPathData::command(char letter, std::string& text) {
  if (letter != last_) {
    text += letter;
    separate_ = false;
  }
  last_ = letter == 'm' ? 'l' : letter;  // moves go on as lines
}

void SvgPathData::raw_number(const std::string& digits, std::string& text) {
  const bool joins =
      digits.front() == '-' || (digits.front() == '.' && pointed_);
  if (separate_ && !joins) text += ' ';
  text += digits;
  separate_ = true;
  pointed_ = digits.find('.') != std::string::npos;
}

void SvgPathData::number(std::int64_t value, std::string& text) {
  digits_.clear();
  append_decimal(digits_, value, decimals_, true);
  raw_number(digits_, text);
}

void SvgPathData::flag(bool value, std::string& text) {
  if (separate_) text += ' ';
  text += value ? '1' : '0';
  separate_ = true;
  pointed_ = false;
}

void SvgPathData::line(WidePoint move, std::string& text) {
  if (move.y == 0) {
    command('h', text);
    number(move.x, text);
  } else if (move.x == 0) {
    command('v', text);
    number(move.y, text);
  } else {
    command('l', text);
    number(move.x, text);
    number(move.y, text);
  }
}

/// The radius in so few digits that the circle through both ends stays within
/// the limit of the true one, and its centre so near that rounding to path
/// units finds it again.
void SvgPathData::find_radius(const Piece& piece) {
  const RealCircle circle = circle_of(piece);
  const double half_chord = std::hypot(static_cast<double>(piece.end.x),
                                       static_cast<double>(piece.end.y)) /
                            2;
  const double unit = std::pow(10.0, -decimals_);
  const double height = std::sqrt(
      std::max(0.0, circle.radius * circle.radius - half_chord * half_chord));
  for (int digits = 1; digits <= 16; ++digits) {
    digits_.clear();
    append_real(digits_, circle.radius * unit, digits);
    double read = 0;
    std::from_chars(digits_.data(), digits_.data() + digits_.size(), read);
    read /= unit;
    // A radius below half the chord is read as half the chord.
    const double now =
        std::sqrt(std::max(0.0, read * read - half_chord * half_chord));
    const double shift = std::fabs(now - height);
    const double bulge = is_large(piece)
                             ? read + now - circle.radius - height
                             : (read - now) - (circle.radius - height);
    if (shift < 0.25 && std::fabs(bulge) <= limit_) break;
  }
  if (digits_.starts_with("0.")) digits_.erase(0, 1);
}

void SvgPathData::half_circle(WidePoint move, bool ascending,
                              std::string& text) {
  // Any radius up to the half chord is read as the half chord.
  const auto root = static_cast<std::int64_t>(std::floor(
      std::hypot(static_cast<double>(move.x), static_cast<double>(move.y)) /
      2));
  command('a', text);
  number(std::max<std::int64_t>(root, 1), text);
  number(std::max<std::int64_t>(root, 1), text);
  flag(false, text);
  flag(false, text);
  flag(ascending, text);
  number(move.x, text);
  number(move.y, text);
}

void SvgPathData::arc(const Piece& piece, std::string& text) {
  if (piece.is_circle()) {
    const WidePoint across{2 * piece.centre.x, 2 * piece.centre.y};
    half_circle(across, piece.ascending, text);
    half_circle({-across.x, -across.y}, piece.ascending, text);
    return;
  }
  find_radius(piece);
  const std::string digits = digits_;
  command('a', text);
  raw_number(digits, text);
  raw_number(digits, text);
  flag(false, text);
  flag(is_large(piece), text);
  flag(piece.ascending, text);
  number(piece.end.x, text);
  number(piece.end.y, text);
}

void SvgPathData::add(const Outline& outline, std::string& text) {
  const WidePoint move = outline.origin - at_;
  command('m', text);
  number(move.x, text);
  number(move.y, text);
  at_ = outline.origin;
  std::size_t count = outline.pieces.size();
  // z draws the last line, unless it has no length.
  if (outline.closed && count > 0 && !outline.pieces[count - 1].is_arc &&
      outline.pieces[count - 1].end != WidePoint{}) {
    --count;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Piece& piece = outline.pieces[i];
    if (piece.is_arc) {
      arc(piece, text);
    } else {
      line(piece.end, text);
    }
    at_ = at_ + piece.end;
  }
  // A point is drawn only as a line without length.
  if (!outline.closed && count == 0) line({}, text);
  if (outline.closed) {
    text += 'z';
    last_ = 'z';
    separate_ = false;
    at_ = outline.origin;
  }
}

}  // namespace unstep
