#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/output_format.h"
#include "cli/quantity.h"
#include "cli/verbs.h"
#include "unstep/codec.h"
#include "unstep/formats.h"
#include "unstep/reverse.h"

/// The options that several verbs share: one name, one help line, one syntax.
namespace unstep::cli {

/// How an input drawing is read.
struct InputOptions {
  enum class Kind : std::uint8_t { automatic, raster, vector, pulses };
  Kind kind = Kind::automatic;
  VectorFormat vector = VectorFormat::svg;  ///< when kind == vector
  PulseFormat pulses = PulseFormat::csv;    ///< when kind == pulses
  PulseReadOptions decoding;                ///< its limits are not used
  Threshold threshold;
  PixelWork work;
  std::optional<Quantity> grid;  ///< vectors become steps on this grid
  double curve_tolerance = 0;    ///< VectorReadOptions
  DecodeLimits limits;
  int jobs = 1;
  bool checksum = false;  ///< tell Source::crc32()
};

/// How chains and contours become lines, if they do.
struct LineOptions {
  enum class Method : std::uint8_t {
    none,       ///< they stay what they are, step for step
    tolerance,  ///< lines and arcs within `tolerance`
    device      ///< the segments of SU 1089551
  };
  /// What of ink becomes lines.
  enum class Trace : std::uint8_t {
    contour,     ///< its edges
    centreline,  ///< strokes along its middle
    automatic    ///< strokes where they draw the ink, else its edges
  };
  Method method = Method::none;
  Trace trace = Trace::contour;
  Quantity tolerance;
  bool arcs = true;
  bool travel = false;  ///< order for short ways between lines
};

/// How pages become a file.
struct PackOptions {
  bool verify = true;
  int bands = 0;
  Effort effort = Effort::standard;
  LineOptions lines;
  Metadata metadata;
};

/// What a verb tells its user.
struct ReportOptions {
  bool quiet = false;
  bool json = false;
};

void add_quiet(CLI::App& verb, bool& quiet);
void add_force(CLI::App& verb, bool& force);
void add_json(CLI::App& verb, bool& json);

/// --jobs; all cores unless given.
void add_jobs(CLI::App& verb, int& jobs);

/// --max-pixels, --max-steps, --max-memory.
void add_limits(CLI::App& verb, DecodeLimits& limits);

/// --from, --grid, --curves, those of add_pixels and of add_decoding.
void add_input_kind(CLI::App& verb, InputOptions& options);

/// --channels, --counts and --trigger, for recordings of encoders.
void add_decoding(CLI::App& verb, PulseReadOptions& options);

/// --threshold, --invert, --despeckle, --fill-holes and --deskew.
void add_pixels(CLI::App& verb, InputOptions& options);

/// --no-verify, --bands, --meta, --effort and those of add_lines.
void add_pack(CLI::App& verb, PackOptions& options);

/// --tolerance, --reverse, --no-arcs, --trace and --order.
void add_lines(CLI::App& verb, LineOptions& options);

/// --tolerance and --no-arcs; `words` say what is within the tolerance of what.
CLI::Option* add_tolerance(CLI::App& verb, LineOptions& options,
                           const std::string& words);

/// --effort.
CLI::Option* add_effort(CLI::App& verb, Effort& effort);

/// --to: the format to write.
void add_to(CLI::App& verb, std::optional<OutputFormat>& format);

/// --page: a page by its number from 1.
void add_page(CLI::App& verb, std::uint64_t& page);

/// --box: a part of the page, "x,y,width,height" in grid units.
void add_box(CLI::App& verb, std::optional<Box>& box);

/// One input path, required.
void add_input(CLI::App& verb, std::string& path, const char* help);

/// One or more input paths, required.
void add_inputs(CLI::App& verb, std::vector<std::string>& paths,
                const char* help);

/// A whole number (quantity.h) within a range.
void add_number(CLI::App& verb, const char* name, std::int32_t& number,
                std::int32_t least, std::int32_t most, const char* help);

/// The last call for a verb: wraps the help of its options and puts the
/// examples and the exit codes below them.
void finish_verb(CLI::App& verb, const char* examples);

}  // namespace unstep::cli
