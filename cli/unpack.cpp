#include "cli/unpack.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "unstep/formats.h"

namespace unstep::cli {
namespace {

enum class Nature : std::uint8_t { ink, chains, paths, program };

/// What a page is to its user: outlines within a tolerance stand for the ink
/// that they were made from.
Nature nature_of(const PageEntry& page) {
  if (page.kind == PageKind::ink) return Nature::ink;
  if (page.kind == PageKind::chains) return Nature::chains;
  if (page.kind == PageKind::program) return Nature::program;
  const bool outlines = page.paint == Paint::fill && page.canvas.width > 0 &&
                        page.fidelity.kind != Fidelity::Kind::exact;
  return outlines ? Nature::ink : Nature::paths;
}

}  // namespace

Result<OutputFormat> natural_format(const FileInfo& info,
                                    const std::vector<std::size_t>& pages) {
  const Nature first = nature_of(info.pages[pages.front()]);
  const bool mixed = std::any_of(pages.begin(), pages.end(), [&](auto page) {
    return nature_of(info.pages[page]) != first;
  });
  if (mixed) {
    return Error{ErrorCode::unsupported,
                 "holds pages of ink, chains or lines together; choose --to "
                 "FORMAT, or decompress them one by one with --page N"};
  }
  if (first == Nature::chains) return OutputFormat::freeman;
  if (first == Nature::paths) return OutputFormat::svg;
  if (first == Nature::program) return OutputFormat::program;
  return pages.size() == 1 ? OutputFormat::png : OutputFormat::tiff;
}

Status check_kinds(const FileInfo& info, const std::vector<std::size_t>& pages,
                   OutputFormat format) {
  for (const std::size_t index : pages) {
    const PageEntry& page = info.pages[index];
    if (format == OutputFormat::program && page.kind != PageKind::program) {
      return Error{ErrorCode::unsupported,
                   fmt::format("page {} is a drawing; unstep convert makes "
                               "programs of drawings",
                               index + 1)};
    }
    if (format != OutputFormat::freeman || page.kind != PageKind::paths ||
        page.fidelity.kind == Fidelity::Kind::device) {
      continue;
    }
    return Error{ErrorCode::unsupported,
                 fmt::format("page {} is lines, and Freeman text holds unit "
                             "steps; choose another --to, or convert it with "
                             "--grid",
                             index + 1)};
  }
  return {};
}

std::string numbered(const std::string& path, std::size_t number) {
  std::filesystem::path name(path);
  const std::string ending = name.extension().string();
  name.replace_extension();
  return fmt::format("{}-{:04}{}", name.string(), number, ending);
}

std::vector<OutputFile> plan_files(const std::string& path,
                                   const std::vector<std::size_t>& pages,
                                   OutputFormat format, bool together) {
  const bool one_file = pages.size() == 1 || holds_pages(format) ||
                        (together && format == OutputFormat::pbm);
  if (one_file) return {{path, pages}};
  std::vector<OutputFile> files;
  for (const std::size_t page : pages) {
    files.push_back({numbered(path, page + 1), {page}});
  }
  return files;
}

Status unpack(const PageGiver& give, std::size_t count,
              const std::vector<std::size_t>& pages, PageWriter writer,
              const std::function<bool()>& next_page,
              std::vector<std::string>& notes) {
  const auto fail = [count](std::size_t index, const Error& error) {
    return Error{error.code, on_page(index, count, error.message)};
  };
  for (const std::size_t index : pages) {
    Result<Page> page = give(index);
    if (!page) return fail(index, page.error());
    std::vector<std::string> page_notes;
    const Status added = writer.add(*std::move(page), page_notes);
    if (!added) return fail(index, added.error());
    for (const std::string& note : page_notes) {
      notes.push_back(on_page(index, count, note));
    }
    if (!next_page()) return Error{ErrorCode::cancelled, "interrupted"};
  }
  return writer.finish();
}

}  // namespace unstep::cli
