#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.h"
#include "unstep/codec.h"
#include "unstep/formats.h"
#include "unstep/result.h"

/// A drawing file of any kind, read page by page.
namespace unstep::cli {

/// A page, and what the user should know of how it was read.
struct SourcePage {
  Page page;
  bool lossless = true;
  std::vector<std::string> notes;
  std::vector<std::string> work;  ///< RasterPage
};

/// Raster image, vector drawing, Freeman text or .ustp, recognised by content
/// unless the options say; a program of a machine by its name.
class Source {
 public:
  /// `path` "-" is standard input. Errors do not repeat the path.
  static Result<Source> open(const std::string& path,
                             const InputOptions& options);

  /// "pbm", "tiff", "svg", "freeman", "ustp", ...
  [[nodiscard]] std::string_view format() const { return format_; }
  [[nodiscard]] std::size_t page_count() const;
  [[nodiscard]] bool is_ustp() const { return ustp_.has_value(); }

  /// Of the whole input file.
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// CRC-32 (zlib) of it. REQUIRES: InputOptions::checksum.
  [[nodiscard]] std::uint32_t crc32() const { return crc32_; }

  /// Page `index`, below page_count(). A page of vectors can be read once;
  /// with InputOptions::grid it is one of chains.
  Result<SourcePage> read(std::size_t index);

  /// Gives back the memory of a raster file after its last page was read; no
  /// page can be read afterwards.
  void release() { raster_.reset(); }

 private:
  Source() = default;
  static Result<Source> open_raster(std::vector<std::uint8_t> file,
                                    const InputOptions& options);
  static Result<Source> open_vector(const std::vector<std::uint8_t>& file,
                                    VectorFormat format,
                                    const InputOptions& options);
  static Result<Source> open_pulses(const std::vector<std::uint8_t>& file,
                                    PulseFormat format,
                                    const InputOptions& options);
  static Result<Source> recognise(const std::string& path,
                                  std::vector<std::uint8_t> file,
                                  const InputOptions& options);

  std::string format_;
  std::uint64_t bytes_ = 0;
  std::uint32_t crc32_ = 0;
  std::optional<RasterReader> raster_;
  std::vector<VectorPage> vectors_;
  std::optional<std::string> program_;
  std::optional<Quantity> grid_;
  std::uint64_t max_steps_ = 0;
  // The reader looks into the bytes, which therefore must not move.
  std::unique_ptr<std::vector<std::uint8_t>> ustp_bytes_;
  std::optional<UstpReader> ustp_;
};

}  // namespace unstep::cli
