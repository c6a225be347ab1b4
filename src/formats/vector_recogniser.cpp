#include <algorithm>
#include <array>
#include <string_view>

#include "formats/text_scanner.h"
#include "unstep/formats.h"

namespace unstep {
namespace {

/// How far a root element may be behind comments and a document type.
constexpr std::size_t kProlog = std::size_t{1} << 16;

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) {
    text.remove_prefix(1);
  }
  return text;
}

bool is_svg(std::string_view text) {
  if (!text.starts_with('<')) return false;
  text = text.substr(0, kProlog);
  for (std::size_t at = text.find("svg"); at != text.npos;
       at = text.find("svg", at + 1)) {
    if (at == 0) continue;
    // "<svg" or "<x:svg", then a blank, "/" or ">".
    const std::size_t open = text.rfind('<', at);
    std::string_view before = text.substr(open + 1, at - open - 1);
    if (!before.empty() && before.back() == ':') before.remove_suffix(1);
    const bool named = std::all_of(before.begin(), before.end(), [](char c) {
      return is_letter(c) || is_digit(c);
    });
    const char after = at + 3 < text.size() ? text[at + 3] : '\0';
    if (named && (is_blank(after) || after == '>' || after == '/')) {
      return true;
    }
  }
  return false;
}

bool is_json(std::string_view text) {
  return text.starts_with('{') &&
         text.substr(0, kProlog).find("\"unstep\"") != text.npos;
}

bool is_dxf(std::string_view text) {
  if (text.starts_with("AutoCAD Binary DXF")) return true;
  const std::size_t end = text.find('\n');
  if (end == text.npos) return false;
  std::string_view code = text.substr(0, end);
  while (!code.empty() && is_blank(code.back())) {
    code.remove_suffix(1);
  }
  const std::string_view value = without_blanks(text.substr(end));
  return code == "999" || (code == "0" && value.starts_with("SECTION"));
}

bool is_chain_text(std::string_view text) {
  while (text.starts_with('#')) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    text = without_blanks(text.substr(end));
  }
  constexpr std::array<std::string_view, 5> kWords{"canvas ", "open4", "open8",
                                                   "closed4", "closed8"};
  return std::any_of(kWords.begin(), kWords.end(),
                     [text](auto word) { return text.starts_with(word); });
}

/// One of the instructions that files begin with, and then no word of more
/// letters than an instruction can have.
bool is_hpgl(std::string_view text) {
  constexpr std::array<std::string_view, 14> kFirst{
      "IN", "DF", "IP", "SC", "SP", "PU", "PD",
      "PA", "PR", "BP", "PS", "VS", "RO", "PG"};
  if (text.starts_with("\x1b%") || text.starts_with("\x1b.")) return true;
  while (!text.empty() && (is_blank(text.front()) || text.front() == ';')) {
    text.remove_prefix(1);
  }
  if (text.size() < 3) return false;
  const auto capital = [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  };
  const std::array<char, 2> name{capital(text[0]), capital(text[1])};
  const std::string_view first(name.data(), name.size());
  if (std::find(kFirst.begin(), kFirst.end(), first) == kFirst.end()) {
    return false;
  }
  const char next = text[2];
  return is_digit(next) || is_blank(next) || next == ';' || next == '-' ||
         next == '+' || (is_letter(next) && text.find(';') != text.npos);
}

}  // namespace

std::optional<VectorFormat> recognise_vector(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  const std::string_view text = without_blanks(bytes);
  if (text.starts_with("%PDF-")) return VectorFormat::pdf;
  if (is_svg(text)) return VectorFormat::svg;
  if (is_json(text)) return VectorFormat::json;
  if (is_dxf(text)) return VectorFormat::dxf;
  if (is_chain_text(text)) return VectorFormat::freeman;
  if (is_hpgl(text)) return VectorFormat::hpgl;
  return std::nullopt;
}

}  // namespace unstep
