#include "cli/unpack.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "unstep/formats.h"

namespace unstep::cli {
namespace {

bool any_page(const FileInfo& info, const std::vector<std::size_t>& pages,
              PageKind kind) {
  return std::any_of(pages.begin(), pages.end(), [&](std::size_t page) {
    return info.pages[page].kind == kind;
  });
}

RasterFormat raster_format(OutputFormat format) {
  if (format == OutputFormat::pbm) return RasterFormat::pbm;
  return format == OutputFormat::png ? RasterFormat::png : RasterFormat::tiff;
}

}  // namespace

Result<OutputFormat> natural_format(const FileInfo& info,
                                    const std::vector<std::size_t>& pages) {
  const bool ink = any_page(info, pages, PageKind::ink);
  const bool chains = any_page(info, pages, PageKind::chains);
  if (ink && chains) {
    return Error{
        ErrorCode::unsupported,
        "holds pages of ink and pages of chains, which no format takes "
        "together; decompress them one by one with --page N"};
  }
  if (chains) return OutputFormat::freeman;
  return pages.size() == 1 ? OutputFormat::png : OutputFormat::tiff;
}

Status check_kinds(const FileInfo& info, const std::vector<std::size_t>& pages,
                   OutputFormat format) {
  const bool to_chains = format == OutputFormat::freeman;
  for (const std::size_t page : pages) {
    const bool chains = info.pages[page].kind == PageKind::chains;
    if (chains == to_chains) continue;
    return Error{ErrorCode::unsupported,
                 fmt::format("page {} is {}; it needs --to {}", page + 1,
                             chains ? "chains" : "ink",
                             chains ? "fc" : "png, pbm or tif")};
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
  const bool one_file = pages.size() == 1 || format == OutputFormat::tiff ||
                        (together && format == OutputFormat::pbm);
  if (one_file) return {{path, pages}};
  std::vector<OutputFile> files;
  for (const std::size_t page : pages) {
    files.push_back({numbered(path, page + 1), {page}});
  }
  return files;
}

Result<std::vector<std::uint8_t>> unpack(const UstpReader& reader,
                                         const std::vector<std::size_t>& pages,
                                         OutputFormat format,
                                         const std::function<bool()>& next_page,
                                         std::vector<std::string>& notes) {
  const std::size_t count = reader.info().pages.size();
  const auto fail = [count](std::size_t index, const Error& error) {
    return Error{error.code, on_page(index, count, error.message)};
  };
  if (format == OutputFormat::freeman) {
    Result<Page> page = reader.read_page(pages.front());
    if (!page) return fail(pages.front(), page.error());
    const std::string text = write_freeman(page->drawing);
    if (!next_page()) return Error{ErrorCode::cancelled, "interrupted"};
    return std::vector<std::uint8_t>(text.begin(), text.end());
  }
  Result<RasterWriter> writer = RasterWriter::create(raster_format(format));
  if (!writer) return writer.error();
  for (const std::size_t index : pages) {
    Result<Page> page = reader.read_page(index);
    if (!page) return fail(index, page.error());
    std::vector<std::string> page_notes;
    const Status added = writer->add_page(page->ink, page->info, &page_notes);
    if (!added) return fail(index, added.error());
    for (const std::string& note : page_notes) {
      notes.push_back(on_page(index, count, note));
    }
    if (!next_page()) return Error{ErrorCode::cancelled, "interrupted"};
  }
  return writer->finish();
}

}  // namespace unstep::cli
