#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/options.h"
#include "cli/source.h"
#include "unstep/result.h"

/// A drawing file to the bytes of a .ustp file.
namespace unstep::cli {

/// The .ustp bytes, and what went into them.
struct Packed {
  std::vector<std::uint8_t> bytes;
  std::uint64_t pages = 0;
  std::uint64_t pixels = 0;        ///< of the ink pages
  std::uint64_t packed_bytes = 0;  ///< of the ink pages at 8 pixels a byte
  std::uint64_t chains = 0;
  std::uint64_t steps = 0;  ///< of the chains stored
  std::uint64_t paths = 0;
  std::uint64_t lines = 0;  ///< elements of the paths stored
  std::uint64_t arcs = 0;
  std::uint64_t program_lines = 0;   ///< of programs
  std::uint64_t program_bytes = 0;   ///< as they were read
  std::optional<Fidelity> fidelity;  ///< of the last page of paths
  bool strokes = false;              ///< which is strokes that stand for ink
  std::int32_t width = 0;            ///< of the last page
  std::int32_t height = 0;
  bool lossless = true;
  bool exact = true;  ///< the pages are what is left after `pixel_work`
  std::vector<std::string> pixel_work;  ///< one line a page that had any
  std::vector<std::string> notes;
};

/// Hears what share of the source is done, 0..1, and how many pixels. Returns
/// false to cancel.
using Listener = std::function<bool(double fraction, std::uint64_t pixels)>;

/// Encodes every page, one in memory at a time, as lines where the options say
/// so.
Result<Packed> pack(Source& source, const PackOptions& options, int jobs,
                    const Listener& listener);

/// "1 page, 1728 x 2376 px, 12,345 bytes, 2.4 % of 513,216 packed, verified".
[[nodiscard]] std::string describe(const Packed& packed, bool verified);

/// " within 1 px", " within 1 px on each axis", " within 1 px of centrelines";
/// nothing for what is exact.
[[nodiscard]] std::string describe_bound(const Fidelity& fidelity,
                                         std::string_view unit = "px",
                                         bool strokes = false);

/// Adds "page 2: " to a message about one of several pages, unless it is there.
[[nodiscard]] std::string on_page(std::size_t index, std::size_t count,
                                  std::string_view message);

}  // namespace unstep::cli
