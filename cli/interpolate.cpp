#include "unstep/interpolate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/exit_code.h"
#include "cli/interpolate_output.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/quantity.h"
#include "cli/verbs.h"

namespace unstep::cli {
namespace {

struct Request {
  std::string method;
  std::vector<std::string> deltas;
  std::vector<std::string> arc;
  bool ccw = false;
  bool list = false;
  bool table = false;
  bool csv = false;
  bool json = false;
  InterpolatorOptions options;
};

ExitCode refuse(std::string_view reason) {
  return report_usage("interpolate", reason);
}

ExitCode refuse(const Error& error) {
  // A method that cannot draw what was asked is a matter of usage here.
  if (error.code == ErrorCode::unsupported ||
      error.code == ErrorCode::invalid_argument) {
    return refuse(error.message);
  }
  return report_error("interpolate", error);
}

/// A length where no scale is known: mm and in are refused.
Result<double> grid_units(const Result<Quantity>& quantity) {
  if (!quantity) return quantity.error();
  return to_grid_units(*quantity, {}, Resolution::Unit::none);
}

/// A way along an axis, whole grid units of int32.
Result<std::int32_t> parse_way(std::string_view name, const std::string& word) {
  const Result<double> value = grid_units(parse_signed_quantity(word));
  if (!value) {
    const std::string& reason = value.error().message;
    return Error{value.error().code,
                 reason.starts_with('\'')
                     ? fmt::format("{} {}", name, reason)
                     : fmt::format("{} '{}': {}", name, word, reason)};
  }
  using Limits = std::numeric_limits<std::int32_t>;
  if (*value < Limits::min() || *value > Limits::max()) {
    return Error{ErrorCode::out_of_range,
                 fmt::format("{} '{}' is outside {} .. {}", name, word,
                             Limits::min(), Limits::max())};
  }
  if (*value != std::trunc(*value)) {
    return Error{
        ErrorCode::invalid_argument,
        fmt::format("{} '{}' is not a whole number of grid units", name, word)};
  }
  return static_cast<std::int32_t>(*value);
}

/// As many as there are names; on failure says which one.
Result<std::vector<std::int32_t>> parse_ways(
    const std::vector<std::string>& words,
    const std::vector<std::string_view>& names) {
  std::vector<std::int32_t> ways;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Result<std::int32_t> way = parse_way(names[i], words[i]);
    if (!way) return way.error();
    ways.push_back(*way);
  }
  return ways;
}

ExitCode list_methods() {
  for (const MethodInfo& info : methods()) {
    const std::string_view draws = info.lines && info.arcs ? "lines, arcs"
                                   : info.lines            ? "lines"
                                                           : "arcs";
    fmt::print("{:<16} {:<3} {} ({})\n", info.name, info.tag, info.description,
               draws);
  }
  return ExitCode::ok;
}

Result<Interpolator> make(const Request& request, Method method) {
  if (request.arc.empty()) {
    const auto d = parse_ways(request.deltas, {"DX", "DY"});
    if (!d) return d.error();
    return Interpolator::line(method, {(*d)[0], (*d)[1]}, request.options);
  }
  const auto a = parse_ways(request.arc, {"CX", "CY", "EX", "EY"});
  if (!a) return a.error();
  const Arc arc{{(*a)[0], (*a)[1]}, {(*a)[2], (*a)[3]}, !request.ccw};
  return Interpolator::arc(method, arc, request.options);
}

ExitCode interpolate_verb(const Request& request) {
  if (request.list) return list_methods();
  const bool arc = !request.arc.empty();
  if (arc && !request.deltas.empty())
    return refuse("give either DX DY or --arc, not both");
  if (!arc && request.deltas.size() != 2)
    return refuse(fmt::format(
        "DX DY or --arc CX CY EX EY is needed, got {} "
        "number{}",
        request.deltas.size(), request.deltas.size() == 1 ? "" : "s"));
  if (request.ccw && !arc) return refuse("--ccw belongs to --arc");
  if (request.table + request.csv + request.json > 1)
    return refuse("--table, --csv and --json exclude each other");
  const std::string name = !request.method.empty() ? request.method
                           : arc                   ? "circular"
                                                   : "device";
  const std::optional<Method> method = find_method(name);
  if (!method)
    return refuse(fmt::format(
        "unknown method '{}'; unstep interpolate --list shows them", name));
  Result<Interpolator> run = make(request, *method);
  if (!run) return refuse(run.error());
  const TickForm form = request.table  ? TickForm::table
                        : request.csv  ? TickForm::csv
                        : request.json ? TickForm::json
                                       : TickForm::steps;
  if (!write_ticks(*run, method_info(*method), form)) {
    return report_error("standard output",
                        {ErrorCode::io_error, "cannot write"});
  }
  return ExitCode::ok;
}

/// A word that stands for a value.
template <class Value>
void add_choice(CLI::App& verb, const char* name, Value& value,
                std::initializer_list<std::pair<std::string_view, Value>> words,
                const char* help) {
  const std::vector choices(words);
  const auto set = [name, &value, choices](const std::string& text) {
    std::string known;
    for (const auto& [word, meaning] : choices) {
      if (word == text) {
        value = meaning;
        return;
      }
      known += known.empty()                  ? ""
               : word == choices.back().first ? " or "
                                              : ", ";
      known += word;
    }
    throw CLI::ValidationError(name,
                               fmt::format("'{}' is not {}", text, known));
  };
  verb.add_option_function<std::string>(name, set, help)->type_name("WORD");
}

void add_feed(CLI::App& verb, double& feed) {
  const auto set = [&feed](const std::string& text) {
    const Result<double> value = grid_units(parse_quantity(text));
    if (!value) throw CLI::ValidationError("--feed", value.error().message);
    feed = *value;
  };
  verb.add_option_function<std::string>(
          "--feed", set,
          "Vk, grid units per second: increments, general, circular [16]")
      ->type_name("LENGTH");
}

void add_period(CLI::App& verb, double& period) {
  const auto set = [&period](const std::string& text) {
    const Result<double> value = parse_seconds(text);
    if (!value) throw CLI::ValidationError("--period", value.error().message);
    period = *value;
  };
  verb.add_option_function<std::string>("--period", set,
                                        "Tk, seconds: increments, general [1]")
      ->type_name("TIME");
}

void add_method_options(CLI::App& verb, InterpolatorOptions& options) {
  add_feed(verb, options.feed);
  add_period(verb, options.period);
  add_number(verb, "--bits", options.rate_bits, 1, kMaxRateBits,
             "rate-multiplier: register width n, 1 to 32; frame of 2^n");
  add_number(verb, "--first-step", options.first_step, 1, 1 << 20,
             "increments: H0, a power of two up to 2^20");
  add_number(verb, "--word-length", options.word_length, kMinWordLength,
             kMaxWordLength, "cordic, meggitt, rom, general: digits, 8 to 52");
  add_number(verb, "--rom-step", options.rom_bits, kMinRomBits, kMaxRomBits,
             "rom: table step 2^-N rad, 4 to 10");
  add_choice(
      verb, "--rom-form", options.rom_form,
      {{"values", RomForm::values}, {"differences", RomForm::differences}},
      "rom: values or differences");
  add_choice(verb, "--correction", options.rom_correction,
             {{"linear", RomCorrection::linear},
              {"parabolic", RomCorrection::parabolic},
              {"cubic", RomCorrection::cubic}},
             "rom: linear, parabolic or cubic");
  add_choice(verb, "--source", options.source,
             {{"cordic", SineSource::cordic},
              {"meggitt", SineSource::meggitt},
              {"rom", SineSource::rom}},
             "general: cordic, meggitt or rom");
  verb.add_flag("--diagonal", options.combined,
                "circular: diagonal steps where they are nearer");
}

constexpr const char* kInterpolateExamples =
    "  unstep interpolate 7 3                  steps 0020020020\n"
    "  unstep interpolate --table 7 3          the registers after each step\n"
    "  unstep interpolate --arc 0 -50 50 -50   a quarter of a circle\n"
    "  unstep interpolate --method general --feed 200px --period 10ms \\\n"
    "    --arc 500 0 0 0 --ccw                 a full circle, per period\n"
    "\n"
    "Steps are Freeman codes 0 to 7, counter-clockwise from east, y up; idle\n"
    "pulses are left out, or '.' in a table. Methods that work per period\n"
    "print 'dx dy' per period. Lengths are grid units: 12 and 12px are the "
    "same,\n"
    "mm and in are refused, for there is no scale here.\n";

}  // namespace

void add_interpolate(CLI::App& app, Context& context) {
  auto request = std::make_shared<Request>();
  CLI::App* verb = app.add_subcommand(
      "interpolate", "Draw a line or an arc as unit steps or increments");
  verb->add_option("--method", request->method,
                   "Which interpolator [device, for arcs circular]")
      ->type_name("NAME");
  verb->add_flag("--list", request->list,
                 "List the methods with their tags in docs/algorithms.md");
  verb->add_option("DX DY", request->deltas,
                   "The end of the line, whole 32-bit numbers")
      ->expected(0, 2)
      ->type_name("");
  verb->add_option("--arc", request->arc,
                   "CX CY EX EY: centre and end relative to the start; end "
                   "0 0 is the full circle")
      ->expected(4)
      ->type_name("LENGTH");
  verb->add_flag("--ccw", request->ccw, "Counter-clockwise arc");
  verb->add_flag("--table", request->table,
                 "One row per tick: the move, then the registers");
  verb->add_flag("--csv", request->csv, "Comma-separated, with a header");
  verb->add_flag("--json", request->json, "One JSON object");
  add_method_options(*verb, request->options);
  finish_verb(*verb, kInterpolateExamples);
  verb->callback([request, &context] {
    context.run = [request] { return interpolate_verb(*request); };
  });
}

}  // namespace unstep::cli
