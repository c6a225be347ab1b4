#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/output_format.h"
#include "cli/pack.h"
#include "unstep/codec.h"
#include "unstep/result.h"

/// The pages of a .ustp file to files of other formats.
namespace unstep::cli {

/// The format that holds these pages in one file: PNG for one ink page, TIFF
/// for several, Freeman text for one page of chains. unsupported, with advice,
/// if there is none.
Result<OutputFormat> natural_format(const FileInfo& info,
                                    const std::vector<std::size_t>& pages);

/// unsupported, with advice, if a page is not of the format's kind.
Status check_kinds(const FileInfo& info, const std::vector<std::size_t>& pages,
                   OutputFormat format);

/// A file to write and the pages it holds.
struct OutputFile {
  std::string path;
  std::vector<std::size_t> pages;
};

/// How pages become files: TIFF takes all of them, PNG, PBM and Freeman text
/// one each, numbered NAME-0001.png and so on if there are several. With
/// `together` PBM takes all as well, as netpbm's programs do.
[[nodiscard]] std::vector<OutputFile> plan_files(
    const std::string& path, const std::vector<std::size_t>& pages,
    OutputFormat format, bool together);

/// "dir/page.png" and 3 to "dir/page-0003.png".
[[nodiscard]] std::string numbered(const std::string& path, std::size_t number);

/// The bytes of one output file. Notes name what the format cannot carry.
Result<std::vector<std::uint8_t>> unpack(const UstpReader& reader,
                                         const std::vector<std::size_t>& pages,
                                         OutputFormat format,
                                         const std::function<bool()>& next_page,
                                         std::vector<std::string>& notes);

}  // namespace unstep::cli
