#include "cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <thread>

#include "cli/exit_code.h"
#include "cli/quantity.h"

namespace unstep::cli {
namespace {

constexpr std::uint64_t kMaxJobs = 1024;
constexpr std::uint64_t kMaxBands = 65535;

/// Room for the text beside CLI11's 30 columns of option names.
constexpr std::size_t kHelpWidth = 49;

/// Breaks a line between words.
std::string wrapped(const std::string& text, std::size_t width) {
  std::string out;
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::size_t length = end - at;
    if (column > 0 && column + 1 + length > width) {
      out += '\n';
      column = 0;
    } else if (column > 0) {
      out += ' ';
      ++column;
    }
    out += text.substr(at, length);
    column += length;
    at = end + 1;
  }
  return out;
}

/// An option with a count (quantity.h) within a range.
template <class Number>
CLI::Option* add_count(CLI::App& verb, const char* name, Number& number,
                       std::uint64_t least, std::uint64_t most,
                       const char* help) {
  const std::string names = name;
  const std::string long_name = names.substr(names.find("--"));
  const auto set = [long_name, &number, least, most](const std::string& text) {
    const Result<std::uint64_t> count = parse_count(text);
    if (!count) throw CLI::ValidationError(long_name, count.error().message);
    if (*count < least || *count > most) {
      throw CLI::ValidationError(
          long_name,
          fmt::format("'{}' is not within {} to {}", text, least, most));
    }
    number = static_cast<Number>(*count);
  };
  return verb.add_option_function<std::string>(name, set, help);
}

void set_threshold(Threshold& threshold, const std::string& text) {
  using Kind = Threshold::Kind;
  constexpr std::array<std::pair<std::string_view, Kind>, 4> kMethods{
      {{"auto", Kind::automatic},
       {"otsu", Kind::otsu},
       {"sauvola", Kind::sauvola},
       {"local", Kind::local}}};
  for (const auto& [word, kind] : kMethods) {
    if (text != word) continue;
    threshold.kind = kind;
    return;
  }
  const Result<std::uint64_t> level = parse_count(text);
  if (!level || *level < 1 || *level > 255) {
    throw CLI::ValidationError(
        "--threshold", fmt::format("'{}' is neither a level of 1 to 255 nor "
                                   "auto, otsu, sauvola or local",
                                   text));
  }
  threshold.kind = Kind::fixed;
  threshold.level = static_cast<int>(*level);
}

void set_invert(PixelWork& work, const std::string& text) {
  if (text == "auto") {
    work.invert = PixelWork::Invert::automatic;
  } else if (text == "yes") {
    work.invert = PixelWork::Invert::yes;
  } else if (text == "no") {
    work.invert = PixelWork::Invert::no;
  } else {
    throw CLI::ValidationError(
        "--invert", fmt::format("'{}' is not auto, yes or no", text));
  }
}

/// A length above 0.
Quantity parse_positive(const std::string& option, const std::string& text) {
  const Result<Quantity> length = parse_quantity(text);
  if (!length) throw CLI::ValidationError(option, length.error().message);
  if (!(length->value > 0)) {
    throw CLI::ValidationError(option,
                               fmt::format("'{}' is not above 0", text));
  }
  return *length;
}

void set_kind(InputOptions& options, const std::string& text) {
  using Kind = InputOptions::Kind;
  constexpr std::array<std::pair<std::string_view, VectorFormat>, 5> kVectors{
      {{"svg", VectorFormat::svg},
       {"dxf", VectorFormat::dxf},
       {"hpgl", VectorFormat::hpgl},
       {"json", VectorFormat::json},
       {"freeman", VectorFormat::freeman}}};
  if (text == "raster") {
    options.kind = Kind::raster;
    return;
  }
  constexpr std::array<std::pair<std::string_view, PulseFormat>, 5> kPulses{
      {{"csv", PulseFormat::csv},
       {"vcd", PulseFormat::vcd},
       {"sr", PulseFormat::sigrok},
       {"raw2", PulseFormat::raw2},
       {"raw4", PulseFormat::raw4}}};
  for (const auto& [word, format] : kPulses) {
    if (text != word) continue;
    options.kind = Kind::pulses;
    options.pulses = format;
    return;
  }
  for (const auto& [word, format] : kVectors) {
    if (text != word) continue;
    options.kind = Kind::vector;
    options.vector = format;
    return;
  }
  throw CLI::ValidationError(
      "--from",
      fmt::format(
          "'{}' is not raster, svg, dxf, hpgl, json, freeman, csv, vcd, "
          "sr, raw2 or raw4",
          text));
}

void set_channels(PulseReadOptions& options, const std::string& text) {
  options.channels.clear();
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    options.channels.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  const std::size_t count = options.channels.size();
  if (count != 2 && count != 4) {
    throw CLI::ValidationError(
        "--channels", fmt::format("'{}' is not A,B or XA,XB,YA,YB", text));
  }
}

void set_counts(PulseReadOptions& options, const std::string& text) {
  if (text == "x1") {
    options.counts = 1;
  } else if (text == "x2") {
    options.counts = 2;
  } else if (text == "x4") {
    options.counts = 4;
  } else {
    throw CLI::ValidationError("--counts",
                               fmt::format("'{}' is not x1, x2 or x4", text));
  }
}

void set_trigger(PulseReadOptions& options, const std::string& text) {
  const char* end = text.data() + text.size();
  const auto [comma, low_failed] =
      std::from_chars(text.data(), end, options.low);
  bool good = low_failed == std::errc() && comma != end && *comma == ',';
  if (good) {
    const auto [stop, failed] = std::from_chars(comma + 1, end, options.high);
    good = failed == std::errc() && stop == end && options.low < options.high;
  }
  if (!good) {
    throw CLI::ValidationError(
        "--trigger",
        fmt::format("'{}' is not LOW,HIGH, the lower first", text));
  }
}

void set_method(LineOptions& options, const std::string& text) {
  using Method = LineOptions::Method;
  if (text == "exact") {
    options.method = Method::none;
  } else if (text == "device") {
    options.method = Method::device;
  } else {
    throw CLI::ValidationError(
        "--reverse", fmt::format("'{}' is neither exact nor device", text));
  }
}

Box parse_box(const std::string& text) {
  std::array<std::int64_t, 4> numbers{};
  const char* at = text.data();
  const char* end = at + text.size();
  bool good = true;
  for (std::size_t i = 0; i < numbers.size() && good; ++i) {
    if (i > 0) good = at != end && *at++ == ',';
    const auto [rest, failure] = std::from_chars(at, end, numbers[i]);
    good = good && failure == std::errc();
    at = rest;
  }
  const auto [x, y, width, height] = numbers;
  good = good && at == end && std::abs(x) <= kMaxCoord &&
         std::abs(y) <= kMaxCoord && width >= 1 && height >= 1 &&
         width <= 2 * std::int64_t{kMaxCoord} &&
         height <= 2 * std::int64_t{kMaxCoord};
  if (!good) {
    throw CLI::ValidationError(
        "--box", fmt::format("'{}' is not X,Y,WIDTH,HEIGHT in pixels", text));
  }
  return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
          static_cast<std::uint32_t>(width),
          static_cast<std::uint32_t>(height)};
}

void add_pair(Metadata& metadata, const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw CLI::ValidationError("--meta",
                               fmt::format("'{}' is not key=value", text));
  }
  std::string key = text.substr(0, equals);
  if (key.starts_with("unstep:")) {
    throw CLI::ValidationError(
        "--meta",
        fmt::format("'{}': keys of unstep: are the program's own", text));
  }
  const bool taken =
      std::any_of(metadata.begin(), metadata.end(),
                  [&](const auto& pair) { return pair.first == key; });
  if (taken) {
    throw CLI::ValidationError("--meta",
                               fmt::format("key '{}' is given twice", key));
  }
  metadata.emplace_back(std::move(key), text.substr(equals + 1));
}

void add_trace(CLI::App& verb, LineOptions& options) {
  verb.add_option_function<std::string>(
          "--trace",
          [&options](const std::string& text) {
            if (text == "contour") {
              options.trace = LineOptions::Trace::contour;
            } else if (text == "centerline" || text == "centreline") {
              options.trace = LineOptions::Trace::centreline;
            } else if (text == "auto") {
              options.trace = LineOptions::Trace::automatic;
            } else {
              throw CLI::ValidationError(
                  "--trace", fmt::format("'{}' is not contour, centerline or "
                                         "auto",
                                         text));
            }
          },
          "What lines follow. contour: the edges of the ink; centerline: its "
          "middle, drawn by pens (lossy even without --tolerance); auto: "
          "centerline where pens draw the ink well [contour]")
      ->type_name("WHAT");
}

void add_order(CLI::App& verb, LineOptions& options) {
  verb.add_option_function<std::string>(
          "--order",
          [&options](const std::string& text) {
            if (text != "travel" && text != "given") {
              throw CLI::ValidationError(
                  "--order", fmt::format("'{}' is not given or travel", text));
            }
            options.travel = text == "travel";
          },
          "Order of chains and lines. travel: short ways of the pen or tool "
          "between them, open ones turned where that helps; how much is saved "
          "is said [given]")
      ->type_name("ORDER");
}

}  // namespace

void add_quiet(CLI::App& verb, bool& quiet) {
  verb.add_flag("-q,--quiet", quiet,
                "Say nothing but errors: no report, warnings or progress");
}

void add_force(CLI::App& verb, bool& force) {
  verb.add_flag("-f,--force", force, "Overwrite an existing output");
}

void add_json(CLI::App& verb, bool& json) {
  verb.add_flag("--json", json, "Report as JSON");
}

void add_jobs(CLI::App& verb, int& jobs) {
  jobs = static_cast<int>(std::clamp<std::uint64_t>(
      std::thread::hardware_concurrency(), 1, kMaxJobs));
  add_count(verb, "-j,--jobs", jobs, 1, kMaxJobs,
            "Threads to use [all cores]; never changes the bytes")
      ->type_name("N");
}

void add_limits(CLI::App& verb, DecodeLimits& limits) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  add_count(verb, "--max-pixels", limits.max_pixels, 1, kMost,
            "Refuse pages of more pixels [4Gi]")
      ->type_name("N");
  add_count(verb, "--max-steps", limits.max_steps, 1, kMost,
            "Refuse chain pages of more unit steps [4Gi]")
      ->type_name("N");
  add_count(verb, "--max-memory", limits.max_memory, 1, kMost,
            "Refuse files that need more bytes of memory [2Gi]")
      ->type_name("N");
}

void add_input_kind(CLI::App& verb, InputOptions& options) {
  verb.add_option_function<std::string>(
          "--from",
          [&options](const std::string& text) { set_kind(options, text); },
          "What the input is: raster, svg, dxf, hpgl, json, freeman, or of "
          "encoders csv, vcd, sr, raw2 or raw4 [by its content]")
      ->type_name("KIND");
  add_pixels(verb, options);
  add_decoding(verb, options.decoding);
  verb.add_option_function<std::string>(
          "--grid",
          [&options](const std::string& text) {
            options.grid = parse_positive("--grid", text);
          },
          "For vectors: draw them as unit steps on a grid of this width, 0.1mm "
          "or a number of the file's units [vertices stay what they are]")
      ->type_name("LENGTH");
  verb.add_option_function<std::string>(
          "--curves",
          [&options](const std::string& text) {
            options.curve_tolerance = parse_positive("--curves", text).value;
          },
          "For vectors: curves become lines no farther than this from them, in "
          "the file's units [a thousandth of the drawing's size]")
      ->type_name("N");
}

void add_decoding(CLI::App& verb, PulseReadOptions& options) {
  verb.add_option_function<std::string>(
          "--channels",
          [&options](const std::string& text) { set_channels(options, text); },
          "For encoders: names or columns of the channels A,B of x, or "
          "XA,XB,YA,YB [by their usual names]")
      ->type_name("NAMES");
  verb.add_option_function<std::string>(
          "--counts",
          [&options](const std::string& text) { set_counts(options, text); },
          "For encoders: counts of a cycle, x1, x2 or x4 [x4]")
      ->type_name("N");
  verb.add_option_function<std::string>(
          "--trigger",
          [&options](const std::string& text) { set_trigger(options, text); },
          "For encoders as analogue CSV: a channel is low below LOW and high "
          "above HIGH")
      ->type_name("LOW,HIGH");
}

void add_pixels(CLI::App& verb, InputOptions& options) {
  verb.add_option_function<std::string>(
          "--threshold",
          [&options](const std::string& text) {
            set_threshold(options.threshold, text);
          },
          "For grey and colour: what is ink. Luminance below N (1 to 255); "
          "otsu chooses N; sauvola and local look at the surroundings; auto "
          "is local, or otsu where that does not fit. This loses the greys")
      ->type_name("N|METHOD");
  verb.add_option_function<std::string>(
          "--invert",
          [&options](const std::string& text) {
            set_invert(options.work, text);
          },
          "Ink and paper change places: auto (if more is dark), yes or no [no]")
      ->type_name("WHEN");
  constexpr std::uint64_t kMost = 1000000;
  add_count(verb, "--despeckle", options.work.despeckle, 0, kMost,
            "Remove pieces of ink of at most N pixels [0]")
      ->type_name("N");
  add_count(verb, "--fill-holes", options.work.fill_holes, 0, kMost,
            "Fill holes in ink of at most N pixels [0]")
      ->type_name("N");
  verb.add_flag("--deskew", options.work.deskew,
                "Turn the page straight, by 10 degrees at most; it grows a "
                "little");
}

void add_pack(CLI::App& verb, PackOptions& options) {
  verb.add_flag(
      "--no-verify", [&options](std::int64_t) { options.verify = false; },
      "Skip the decoding and comparing after encoding");
  add_count(verb, "--bands", options.bands, 1, kMaxBands,
            "Cut each raster page into N bands that decode in parallel; costs "
            "bytes [1, more above 64 Mpx]")
      ->type_name("N");
  verb.add_option_function<std::vector<std::string>>(
          "--meta",
          [&options](const std::vector<std::string>& pairs) {
            for (const std::string& pair : pairs) {
              add_pair(options.metadata, pair);
            }
          },
          "Store a text with the file; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_effort(verb, options.effort);
  add_lines(verb, options.lines);
}

CLI::Option* add_tolerance(CLI::App& verb, LineOptions& options,
                           const std::string& words) {
  CLI::Option* tolerance =
      verb.add_option_function<std::string>(
              "--tolerance",
              [&options](const std::string& text) {
                options.tolerance = parse_positive("--tolerance", text);
                options.method = LineOptions::Method::tolerance;
              },
              words)
          ->type_name("LENGTH");
  verb.add_flag(
          "--no-arcs", [&options](std::int64_t) { options.arcs = false; },
          "With --tolerance: lines only")
      ->needs(tolerance);
  return tolerance;
}

void add_lines(CLI::App& verb, LineOptions& options) {
  CLI::Option* tolerance = add_tolerance(
      verb, options,
      "Lossy: contours and chains become lines and arcs that are nowhere "
      "farther than this from them, 1 (pixels), 0.05mm");
  verb.add_option_function<std::string>(
          "--reverse",
          [&options](const std::string& text) { set_method(options, text); },
          "exact: every step is kept; device: the segments of SU 1089551, "
          "within 1 unit per axis [exact]")
      ->type_name("METHOD")
      ->excludes(tolerance);
  add_trace(verb, options);
  add_order(verb, options);
}

CLI::Option* add_effort(CLI::App& verb, Effort& effort) {
  return verb
      .add_option_function<std::string>(
          "--effort",
          [&effort](const std::string& text) {
            if (text == "fast") {
              effort = Effort::fast;
            } else if (text == "standard") {
              effort = Effort::standard;
            } else if (text == "max") {
              effort = Effort::max;
            } else {
              throw CLI::ValidationError(
                  "--effort",
                  fmt::format("'{}' is not fast, standard or max", text));
            }
          },
          "Time to spend: fast, standard or max [standard]")
      ->type_name("LEVEL");
}

void add_to(CLI::App& verb, std::optional<OutputFormat>& format) {
  const auto set = [&format](const std::string& text) {
    format = format_of_word(text);
    if (!format) {
      throw CLI::ValidationError(
          "--to", fmt::format("'{}' is not {}", text, format_words()));
    }
  };
  verb.add_option_function<std::string>(
          "--to", set,
          fmt::format("Format to write: {} [by the name of OUT]",
                      format_words()))
      ->type_name("FORMAT");
}

void add_page(CLI::App& verb, std::uint64_t& page) {
  add_count(verb, "--page", page, 1, 0xffffffff,
            "Only this page, counted from 1")
      ->type_name("N");
}

void add_box(CLI::App& verb, std::optional<Box>& box) {
  verb.add_option_function<std::string>(
          "--box", [&box](const std::string& text) { box = parse_box(text); },
          "Only this part of the page: ink is cut out; of vectors all that "
          "blocks in reach hold")
      ->type_name("X,Y,W,H");
}

void add_input(CLI::App& verb, std::string& path, const char* help) {
  verb.add_option("IN", path, help)->required()->type_name("");
}

void add_inputs(CLI::App& verb, std::vector<std::string>& paths,
                const char* help) {
  verb.add_option("IN", paths, help)->required()->type_name("");
}

void add_number(CLI::App& verb, const char* name, std::int32_t& number,
                std::int32_t least, std::int32_t most, const char* help) {
  add_count(verb, name, number, static_cast<std::uint64_t>(least),
            static_cast<std::uint64_t>(most), help)
      ->type_name("N");
}

void finish_verb(CLI::App& verb, const char* examples) {
  for (CLI::Option* option : verb.get_options()) {
    option->description(wrapped(option->get_description(), kHelpWidth));
  }
  verb.footer(fmt::format("Examples:\n{}\n{}", examples, kExitCodeHelp));
}

}  // namespace unstep::cli
