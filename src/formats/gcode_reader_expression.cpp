#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "formats/characters.h"
#include "formats/gcode_reader_block.h"

/// Expressions and parameters of RS274/NGC: [1 + #2], #<name>, COS[30].
namespace unstep {
namespace {

enum Operation : int {
  no_operation,
  op_and,
  op_or,
  op_xor,
  op_eq,
  op_ne,
  op_gt,
  op_ge,
  op_lt,
  op_le,
  op_add,
  op_subtract,
  op_multiply,
  op_divide,
  op_mod,
  op_power
};

struct OperatorWord {
  std::string_view word;
  Operation operation;
  int level;
};
// The longer of two that begin alike comes first. LinuxCNC's levels.
constexpr std::array<OperatorWord, 16> kOperators{{{"**", op_power, 5},
                                                   {"*", op_multiply, 4},
                                                   {"/", op_divide, 4},
                                                   {"MOD", op_mod, 4},
                                                   {"+", op_add, 3},
                                                   {"-", op_subtract, 3},
                                                   {"EQ", op_eq, 2},
                                                   {"NE", op_ne, 2},
                                                   {"GT", op_gt, 2},
                                                   {"GE", op_ge, 2},
                                                   {"LT", op_lt, 2},
                                                   {"LE", op_le, 2},
                                                   {"AND", op_and, 1},
                                                   {"OR", op_or, 1},
                                                   {"XOR", op_xor, 1},
                                                   {"", no_operation, 0}}};

bool begins_with(std::string_view text, std::string_view word) {
  if (text.size() < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (to_upper(text[i]) != word[i]) return false;
  }
  return true;
}

constexpr double kDegree = std::numbers::pi / 180;

/// LinuxCNC takes numbers this close to each other, or to a whole one, for
/// equal.
constexpr double kNear = 1e-4;

}  // namespace

int GcodeLineReader::peek_operator(int& level) const {
  const std::string_view rest = line_.substr(at_);
  for (const OperatorWord& candidate : kOperators) {
    if (!candidate.word.empty() && begins_with(rest, candidate.word)) {
      level = candidate.level;
      return static_cast<int>(&candidate - kOperators.data());
    }
  }
  level = 0;
  return -1;
}

bool GcodeLineReader::read_operand(Number& result, int depth) {
  if (depth > kMaxDepth) {
    return fail(ErrorCode::limit_exceeded, "an expression is nested too deep");
  }
  skip_blanks();
  bool negative = false;
  if (peek() == '-' || peek() == '+') {
    negative = peek() == '-';
    ++at_;
    skip_blanks();
  }
  const char c = peek();
  if ((c >= '0' && c <= '9') || c == '.') {
    double value = 0;
    const char* const end = line_.data() + line_.size();
    const auto [stop, failed] = std::from_chars(line_.data() + at_, end, value,
                                                std::chars_format::fixed);
    if (failed != std::errc{}) return fail("expected a number");
    at_ = static_cast<std::size_t>(stop - line_.data());
    result = {value, true};
  } else if (c == '[') {
    if (!read_bracket(result, depth + 1)) return false;
  } else if (c == '#') {
    Parameter parameter;
    if (!read_parameter(parameter, depth + 1)) return false;
    result = parameters_.value_of(parameter);
  } else if (to_upper(c) >= 'A' && to_upper(c) <= 'Z') {
    if (!read_function(result, depth + 1)) return false;
  } else {
    return fail("expected a number");
  }
  if (negative) result.value = -result.value;
  return true;
}

bool GcodeLineReader::read_bracket(Number& result, int depth) {
  if (depth > kMaxDepth) {
    return fail(ErrorCode::limit_exceeded, "an expression is nested too deep");
  }
  return expect('[') && read_binary(result, 1, depth) && expect(']');
}

/// Operators of this level or a higher one, left to right.
bool GcodeLineReader::read_binary(Number& result, int level, int depth) {
  if (level > 5) return read_operand(result, depth);
  if (!read_binary(result, level + 1, depth)) return false;
  for (;;) {
    skip_blanks();
    int found_level = 0;
    const int found = peek_operator(found_level);
    if (found < 0 || found_level != level) return true;
    const OperatorWord& chosen = kOperators[static_cast<std::size_t>(found)];
    at_ += chosen.word.size();
    Number right;
    if (!read_binary(right, level + 1, depth) ||
        !apply(chosen.operation, result, right)) {
      return false;
    }
  }
}

bool GcodeLineReader::apply(int operation, Number& left, const Number& right) {
  if (!left.known || !right.known) {
    left = {0, false};
    return true;
  }
  const double a = left.value;
  const double b = right.value;
  double& out = left.value;
  switch (operation) {
    case op_and: out = a != 0 && b != 0 ? 1 : 0; break;
    case op_or: out = a != 0 || b != 0 ? 1 : 0; break;
    case op_xor: out = (a != 0) != (b != 0) ? 1 : 0; break;
    case op_eq: out = std::abs(a - b) < kNear ? 1 : 0; break;
    case op_ne: out = std::abs(a - b) < kNear ? 0 : 1; break;
    case op_gt: out = a > b ? 1 : 0; break;
    case op_ge: out = a >= b ? 1 : 0; break;
    case op_lt: out = a < b ? 1 : 0; break;
    case op_le: out = a <= b ? 1 : 0; break;
    case op_add: out = a + b; break;
    case op_subtract: out = a - b; break;
    case op_multiply: out = a * b; break;
    case op_divide:
      if (b == 0) return fail("division by zero");
      out = a / b;
      break;
    case op_mod:
      if (b == 0) return fail("division by zero");
      out = std::fmod(a, b);
      if (out < 0) out += std::abs(b);
      break;
    default:
      if (a < 0 && b != std::floor(b)) {
        return fail("a broken power of a negative number");
      }
      out = std::pow(a, b);
      break;
  }
  if (!std::isfinite(out)) {
    return fail(ErrorCode::out_of_range, "number too large");
  }
  return true;
}

bool GcodeLineReader::read_function(Number& result, int depth) {
  std::string name;
  while (to_upper(peek()) >= 'A' && to_upper(peek()) <= 'Z') {
    name += to_upper(peek());
    ++at_;
    if (name.size() > 8) break;
  }
  if (name == "EXISTS") return read_exists(result, depth);
  if (!read_bracket(result, depth)) return false;
  const double x = result.value;
  double& out = result.value;
  if (name == "ATAN") {
    Number second;
    if (!expect('/') || !read_bracket(second, depth)) return false;
    result.known = result.known && second.known;
    out = std::atan2(x, second.value) / kDegree;
  } else if (name == "ABS") {
    out = std::abs(x);
  } else if (name == "SIN") {
    out = std::sin(x * kDegree);
  } else if (name == "COS") {
    out = std::cos(x * kDegree);
  } else if (name == "TAN") {
    out = std::tan(x * kDegree);
  } else if (name == "ASIN" || name == "ACOS") {
    if (std::abs(x) > 1) return fail(name + " of a number beyond 1");
    out = (name == "ASIN" ? std::asin(x) : std::acos(x)) / kDegree;
  } else if (name == "EXP") {
    out = std::exp(x);
  } else if (name == "FIX") {
    out = std::floor(x);
  } else if (name == "FUP") {
    out = std::ceil(x);
  } else if (name == "ROUND") {
    out = std::round(x);
  } else if (name == "LN") {
    if (result.known && x <= 0) return fail("LN of a number not above 0");
    out = result.known ? std::log(x) : 0;
  } else if (name == "SQRT") {
    if (x < 0) return fail("SQRT of a negative number");
    out = std::sqrt(x);
  } else {
    return fail("expected a number or a function");
  }
  if (!std::isfinite(out)) {
    return fail(ErrorCode::out_of_range, "number too large");
  }
  return true;
}

bool GcodeLineReader::read_exists(Number& result, int depth) {
  Parameter parameter;
  if (!expect('[')) return false;
  skip_blanks();
  if (!read_parameter(parameter, depth)) return false;
  result = parameters_.exists(parameter);
  return expect(']');
}

bool GcodeLineReader::read_parameter(Parameter& parameter, int depth) {
  if (!expect('#')) return false;
  skip_blanks();
  if (peek() == '<') {
    parameter.named = true;
    parameter.name = read_name();
    if (parameter.name.empty()) return fail("a parameter without a name");
    return true;
  }
  Number number;
  if (!read_operand(number, depth)) return false;
  parameter.known = number.known;
  if (!number.known) return true;
  const double whole = std::round(number.value);
  if (std::abs(number.value - whole) > kNear || whole < 1 || whole > 1e9) {
    return fail(ErrorCode::out_of_range, "no such parameter number");
  }
  parameter.number = static_cast<std::uint32_t>(whole);
  return true;
}

/// "<Some Name>" as "somename".
std::string GcodeLineReader::read_name() {
  std::string name;
  for (++at_; at_ < line_.size() && line_[at_] != '>'; ++at_) {
    const char c = line_[at_];
    if (c == ' ' || c == '\t') continue;
    name += to_upper(c);
  }
  if (at_ == line_.size()) return {};
  ++at_;
  return name;
}

bool GcodeLineReader::read_assignment(GcodeBlock& block) {
  Assignment assignment;
  if (!read_parameter(assignment.target, 0)) return false;
  if (!expect('=') || !read_operand(assignment.value, 0)) return false;
  block.assigns = block.computed = true;
  const Parameter& target = assignment.target;
  // #5161 ... #5400: homes, offsets and the tool of LinuxCNC.
  if (!target.known ||
      (!target.named && target.number >= 5161 && target.number <= 5400)) {
    block.assigns_offset = true;
  }
  assignments_.push_back(std::move(assignment));
  return true;
}

}  // namespace unstep
