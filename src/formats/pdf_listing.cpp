#include "formats/pdf_listing.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

namespace unstep {
namespace {

/// Words of a line, parted by blanks.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string_view::npos) break;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find(' '), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
  return words;
}

template <class Visit>
void for_each_line(std::string_view text, const Visit& visit) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    visit(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

template <class Number>
std::optional<Number> parse(std::string_view text) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, value);
  if (failed != std::errc{} || stop != end) return std::nullopt;
  return value;
}

/// page num type width height color comp bpc enc interp object ID x-ppi y-ppi
/// size ratio; inline images have "[inline]" for object and ID.
std::optional<ListedImage> parse_image(std::string_view line) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.size() < 14) return std::nullopt;
  const auto page = parse<std::size_t>(words[0]);
  const auto width = parse<std::uint32_t>(words[3]);
  const auto height = parse<std::uint32_t>(words[4]);
  const auto components = parse<std::uint32_t>(words[6]);
  if (!page || !width || !height || !components) return std::nullopt;
  const std::size_t ppi = words[10] == "[inline]" ? 11 : 12;
  ListedImage image;
  image.page = *page;
  image.width = *width;
  image.height = *height;
  image.components = std::max(*components, 1U);
  image.x_per_inch = parse<std::uint32_t>(words[ppi]).value_or(0);
  image.y_per_inch = parse<std::uint32_t>(words[ppi + 1]).value_or(0);
  image.is_stencil = words[2] == "stencil";
  image.is_mask = words[2] == "smask" || words[2] == "mask";
  return image;
}

/// Gives the number of pages: "Pages: 3", "Page    1 size: 595 x 842 pts (A4)",
/// "Page    1 rot:  90".
std::size_t read_boxes(std::string_view info,
                       std::map<std::size_t, PdfPage>& pages) {
  std::size_t count = 0;
  for_each_line(info, [&](std::string_view line) {
    const std::vector<std::string_view> words = words_of(line);
    if (words.size() >= 2 && words[0] == "Pages:") {
      count = parse<std::size_t>(words[1]).value_or(0);
    }
    if (words.size() < 4 || words[0] != "Page") return;
    const auto number = parse<std::size_t>(words[1]);
    const auto found = number ? pages.find(*number) : pages.end();
    if (found == pages.end()) return;
    PageBox& box = found->second.box;
    if (words[2] == "size:" && words.size() >= 6) {
      box.width = parse<double>(words[3]).value_or(0);
      box.height = parse<double>(words[5]).value_or(0);
    } else if (words[2] == "rot:") {
      box.rotation = parse<int>(words[3]).value_or(0);
    }
  });
  return count;
}

}  // namespace

PdfListing list_pages(std::string_view list, std::string_view info) {
  std::map<std::size_t, PdfPage> pages;
  std::map<std::size_t, std::size_t> listed;
  for_each_line(list, [&](std::string_view line) {
    std::optional<ListedImage> image = parse_image(line);
    if (!image) return;
    image->in_page = listed[image->page]++;
    PdfPage& page = pages[image->page];
    page.number = image->page;
    page.all_bytes += image->pixels() * image->components;
    if (image->is_mask) return;
    ++page.images;
    if (image->pixels() > page.image.pixels()) page.image = *image;
  });
  PdfListing listing;
  listing.count = read_boxes(info, pages);
  for (auto& [number, page] : pages) {
    if (page.images > 0) listing.pages.push_back(page);
  }
  return listing;
}

}  // namespace unstep
