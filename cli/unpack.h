#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/output_format.h"
#include "cli/pack.h"
#include "cli/page_writer.h"
#include "unstep/codec.h"
#include "unstep/result.h"

/// Pages to files of other formats than .ustp.
namespace unstep::cli {

/// The format that holds these pages in one file: PNG for one page of ink,
/// TIFF for several, Freeman text for one page of chains, SVG for one of
/// paths; paths made from ink at a tolerance count as ink. unsupported, with
/// advice, if there is none.
Result<OutputFormat> natural_format(const FileInfo& info,
                                    const std::vector<std::size_t>& pages);

/// unsupported, with advice, if a page cannot be turned into the format.
Status check_kinds(const FileInfo& info, const std::vector<std::size_t>& pages,
                   OutputFormat format);

/// A file to write and the pages it holds.
struct OutputFile {
  std::string path;
  std::vector<std::size_t> pages;
};

/// How pages become files: TIFF, PDF and JSON take all of them, the others one
/// each, numbered NAME-0001.png and so on if there are several. With
/// `together` PBM takes all as well, as netpbm's programs do.
[[nodiscard]] std::vector<OutputFile> plan_files(
    const std::string& path, const std::vector<std::size_t>& pages,
    OutputFormat format, bool together);

/// "dir/page.png" and 3 to "dir/page-0003.png".
[[nodiscard]] std::string numbered(const std::string& path, std::size_t number);

/// Gives page `index`.
using PageGiver = std::function<Result<Page>(std::size_t index)>;

/// Writes the pages to one output file, its bytes as they come. `count`: of the
/// pages there are, for messages. Notes name what the format cannot carry.
Status unpack(const PageGiver& give, std::size_t count,
              const std::vector<std::size_t>& pages, PageWriter writer,
              const std::function<bool()>& next_page,
              std::vector<std::string>& notes);

}  // namespace unstep::cli
