#include "cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
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
  if (text == "otsu") {
    threshold.kind = Threshold::Kind::otsu;
    return;
  }
  const Result<std::uint64_t> level = parse_count(text);
  if (!level || *level < 1 || *level > 255) {
    throw CLI::ValidationError(
        "--threshold",
        fmt::format("'{}' is neither a level of 1 to 255 nor otsu", text));
  }
  threshold.kind = Threshold::Kind::fixed;
  threshold.level = static_cast<int>(*level);
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
  const auto set_kind = [&options](const std::string& text) {
    if (text == "raster") {
      options.kind = InputOptions::Kind::raster;
    } else if (text == "freeman") {
      options.kind = InputOptions::Kind::freeman;
    } else {
      throw CLI::ValidationError(
          "--from", fmt::format("'{}' is neither raster nor freeman", text));
    }
  };
  verb.add_option_function<std::string>(
          "--from", set_kind,
          "What the input is: raster or freeman [by its content]")
      ->type_name("KIND");
  add_threshold(verb, options.threshold);
}

void add_threshold(CLI::App& verb, Threshold& threshold) {
  verb.add_option_function<std::string>(
          "--threshold",
          [&threshold](const std::string& text) {
            set_threshold(threshold, text);
          },
          "For grey and colour: luminance below N (1 to 255) is ink, or otsu "
          "chooses N. This loses the greys")
      ->type_name("N|otsu");
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
}

void add_to(CLI::App& verb, std::optional<OutputFormat>& format) {
  const auto set = [&format](const std::string& text) {
    format = format_of_word(text);
    if (!format) {
      throw CLI::ValidationError(
          "--to", fmt::format("'{}' is not png, pbm, tif or fc", text));
    }
  };
  verb.add_option_function<std::string>(
          "--to", set,
          "Format to write: png, pbm, tif or fc [by the name of OUT]")
      ->type_name("FORMAT");
}

void add_page(CLI::App& verb, std::uint64_t& page) {
  add_count(verb, "--page", page, 1, 0xffffffff,
            "Only this page, counted from 1")
      ->type_name("N");
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
