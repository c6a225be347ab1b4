#include "unstep/interpolate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/exit_code.h"
#include "cli/verbs.h"

namespace unstep::cli {
namespace {

enum class Output { steps, table, csv, json };

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

ExitCode fail(ExitCode code, std::string_view what) {
  fmt::print(stderr, "unstep interpolate: {}\n", what);
  return code;
}

ExitCode fail(const Error& error) {
  // A method that cannot draw what was asked is a matter of usage here.
  const ExitCode code = error.code == ErrorCode::unsupported
                            ? ExitCode::usage
                            : exit_code_of(error.code);
  return fail(code, error.message);
}

/// Reads whole int32 numbers; on failure says which one.
Result<std::vector<std::int32_t>> parse_numbers(
    const std::vector<std::string>& words,
    const std::vector<std::string_view>& names) {
  std::vector<std::int32_t> numbers;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const char* first = word.data() + (word.starts_with('+') ? 1 : 0);
    const char* last = word.data() + word.size();
    std::int32_t value = 0;
    const auto [end, code] = std::from_chars(first, last, value);
    if (code == std::errc::result_out_of_range)
      return Error{ErrorCode::out_of_range,
                   fmt::format("{} '{}' is outside -2147483648 .. 2147483647",
                               names[i], word)};
    if (code != std::errc() || end != last)
      return Error{
          ErrorCode::invalid_argument,
          fmt::format("{} '{}' is not a whole number", names[i], word)};
    numbers.push_back(value);
  }
  return numbers;
}

/// Collects text and writes it in large pieces; long lines make billions of
/// steps.
class Writer {
 public:
  template <class... Args>
  void print(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(buffer_), format,
                   std::forward<Args>(args)...);
    if (buffer_.size() >= kFlushAt) flush();
  }
  /// True if everything arrived.
  bool finish() {
    flush();
    return std::fflush(stdout) == 0 && good_;
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  static constexpr std::size_t kFlushAt = 1 << 16;
  void flush() {
    good_ = good_ && std::fwrite(buffer_.data(), 1, buffer_.size(), stdout) ==
                         buffer_.size();
    buffer_.clear();
  }
  std::string buffer_;
  bool good_ = true;
};

std::string_view kind_name(Tick::Kind kind) {
  switch (kind) {
    case Tick::Kind::idle: return "idle";
    case Tick::Kind::step: return "step";
    case Tick::Kind::increment: return "increment";
    case Tick::Kind::done: break;
  }
  return "done";
}

void write_steps(Writer& out, Interpolator& run, const MethodInfo& info) {
  std::array<Tick, 1024> ticks;
  for (std::size_t n = run.fill(ticks); n != 0 && out.good();
       n = run.fill(ticks)) {
    for (std::size_t i = 0; i < n; ++i) {
      if (info.increments)
        out.print("{} {}\n", ticks[i].dx, ticks[i].dy);
      else if (ticks[i].kind == Tick::Kind::step)
        out.print("{}", ticks[i].step);
    }
  }
  if (!info.increments) out.print("\n");
}

/// The first column of a table: a Freeman code, "." for an idle pulse, or the
/// increments of the period.
void write_move(Writer& out, const Tick& tick, const MethodInfo& info) {
  if (info.increments)
    out.print("{} {}", tick.dx, tick.dy);
  else if (tick.kind == Tick::Kind::step)
    out.print("{}", tick.step);
  else
    out.print(".");
}

void write_rows(Writer& out, Interpolator& run, const MethodInfo& info,
                Output output) {
  std::array<Register, kMaxRegisters> registers;
  const std::size_t count = run.registers(registers);
  if (output == Output::csv) {
    out.print("tick,kind,step,dx,dy");
    for (std::size_t i = 0; i < count; ++i) out.print(",{}", registers[i].name);
    out.print("\n");
  }
  if (output == Output::json)
    out.print("{{\"method\":\"{}\",\"tag\":\"{}\",\"ticks\":[", info.name,
              info.tag);
  std::uint64_t number = 0;
  for (Tick t = run.next(); t.kind != Tick::Kind::done && out.good();
       t = run.next()) {
    ++number;
    run.registers(registers);
    if (output == Output::table) {
      write_move(out, t, info);
      for (std::size_t i = 0; i < count; ++i)
        out.print(" {}", registers[i].value);
      out.print("\n");
      continue;
    }
    const std::string step =
        t.kind == Tick::Kind::step ? fmt::format("{}", t.step) : "";
    if (output == Output::csv) {
      out.print("{},{},{},{},{}", number, kind_name(t.kind), step, t.dx, t.dy);
      for (std::size_t i = 0; i < count; ++i)
        out.print(",{}", registers[i].value);
      out.print("\n");
      continue;
    }
    out.print("{}\n{{\"kind\":\"{}\",\"step\":{},\"dx\":{},\"dy\":{}",
              number == 1 ? "" : ",", kind_name(t.kind),
              step.empty() ? "null" : step, t.dx, t.dy);
    for (std::size_t i = 0; i < count; ++i)
      out.print("{}\"{}\":{}", i == 0 ? ",\"registers\":{" : ",",
                registers[i].name, registers[i].value);
    out.print("}}}}");
  }
  if (output == Output::json) out.print("\n]}}\n");
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
    const auto d = parse_numbers(request.deltas, {"DX", "DY"});
    if (!d) return d.error();
    return Interpolator::line(method, {(*d)[0], (*d)[1]}, request.options);
  }
  const auto a = parse_numbers(request.arc, {"CX", "CY", "EX", "EY"});
  if (!a) return a.error();
  const Arc arc{{(*a)[0], (*a)[1]}, {(*a)[2], (*a)[3]}, !request.ccw};
  return Interpolator::arc(method, arc, request.options);
}

ExitCode interpolate_verb(const Request& request) {
  if (request.list) return list_methods();
  const bool arc = !request.arc.empty();
  if (arc && !request.deltas.empty())
    return fail(ExitCode::usage, "give either DX DY or --arc, not both");
  if (!arc && request.deltas.size() != 2)
    return fail(ExitCode::usage,
                fmt::format("DX DY or --arc CX CY EX EY is needed, got {} "
                            "number{} (see unstep interpolate --help)",
                            request.deltas.size(),
                            request.deltas.size() == 1 ? "" : "s"));
  if (request.ccw && !arc)
    return fail(ExitCode::usage, "--ccw belongs to --arc");
  if (request.table + request.csv + request.json > 1)
    return fail(ExitCode::usage,
                "--table, --csv and --json exclude each other");
  const std::string name = !request.method.empty() ? request.method
                           : arc                   ? "circular"
                                                   : "device";
  const std::optional<Method> method = find_method(name);
  if (!method)
    return fail(ExitCode::usage,
                fmt::format("unknown method '{}' (unstep interpolate --list "
                            "shows them)",
                            name));
  Result<Interpolator> run = make(request, *method);
  if (!run) return fail(run.error());
  Writer out;
  const MethodInfo& info = method_info(*method);
  if (request.table)
    write_rows(out, *run, info, Output::table);
  else if (request.csv)
    write_rows(out, *run, info, Output::csv);
  else if (request.json)
    write_rows(out, *run, info, Output::json);
  else
    write_steps(out, *run, info);
  if (!out.finish())
    return fail(ExitCode::io, "cannot write to standard output");
  return ExitCode::ok;
}

void add_method_options(CLI::App& verb, InterpolatorOptions& options) {
  verb.add_option("--feed", options.feed,
                  "Vk, units per second (increments, general, circular)")
      ->capture_default_str();
  verb.add_option("--period", options.period,
                  "Tk, seconds (increments, general)")
      ->capture_default_str();
  verb.add_option("--bits", options.rate_bits,
                  "rate-multiplier: register width n, 1..32; frame of 2^n");
  verb.add_option("--first-step", options.first_step,
                  "increments: H0, a power of two up to 2^20");
  verb.add_option("--word-length", options.word_length,
                  "cordic, meggitt, rom, general: digits n, 8..52");
  verb.add_option("--rom-step", options.rom_bits,
                  "rom: table step 2^-S rad, 4..10");
  verb.add_option("--rom-form", options.rom_form, "rom: values or differences")
      ->transform(CLI::CheckedTransformer(std::map<std::string, RomForm>{
          {"values", RomForm::values}, {"differences", RomForm::differences}}));
  verb.add_option("--correction", options.rom_correction,
                  "rom: linear, parabolic or cubic")
      ->transform(CLI::CheckedTransformer(std::map<std::string, RomCorrection>{
          {"linear", RomCorrection::linear},
          {"parabolic", RomCorrection::parabolic},
          {"cubic", RomCorrection::cubic}}));
  verb.add_option("--source", options.source, "general: cordic, meggitt or rom")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, SineSource>{{"cordic", SineSource::cordic},
                                            {"meggitt", SineSource::meggitt},
                                            {"rom", SineSource::rom}}));
  verb.add_flag("--diagonal", options.combined,
                "circular: diagonal steps where they are nearer");
}

}  // namespace

void add_interpolate(CLI::App& app, Context& context) {
  auto request = std::make_shared<Request>();
  CLI::App* verb = app.add_subcommand(
      "interpolate", "Draw a line or an arc as unit steps or increments");
  verb->add_option("--method", request->method,
                   "Which interpolator (default: device, circular for arcs)");
  verb->add_flag("--list", request->list,
                 "List the methods with their tags in docs/algorithms.md");
  verb->add_option("deltas", request->deltas,
                   "DX DY, the end of the line; each any 32-bit number")
      ->expected(0, 2);
  verb->add_option("--arc", request->arc,
                   "CX CY EX EY: centre and end relative to the start; end "
                   "0 0 is the full circle")
      ->expected(4);
  verb->add_flag("--ccw", request->ccw, "Counter-clockwise arc");
  verb->add_flag("--table", request->table,
                 "One row per tick: the move, then the registers");
  verb->add_flag("--csv", request->csv, "Comma-separated, with a header");
  verb->add_flag("--json", request->json, "One JSON object");
  add_method_options(*verb, request->options);
  verb->footer(
      "Steps are Freeman codes 0..7, counter-clockwise from east, y up; idle\n"
      "pulses are left out, or '.' in a table. Methods that work per period\n"
      "print 'dx dy' per period.\n\n"
      "  unstep interpolate 7 3\n"
      "  unstep interpolate --method device --table 7 3\n"
      "  unstep interpolate --arc 0 -50 50 -50\n"
      "  unstep interpolate --method general --feed 200 --period 0.01 --arc "
      "500 0 0 0 --ccw\n");
  verb->callback([request, &context] {
    context.run = [request] { return interpolate_verb(*request); };
  });
}

}  // namespace unstep::cli
