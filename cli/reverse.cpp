#include "unstep/reverse.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

#include "cli/exit_code.h"
#include "cli/message.h"
#include "cli/options.h"
#include "cli/reshape.h"
#include "cli/reverse_lines.h"
#include "cli/source.h"
#include "cli/verbs.h"

namespace unstep::cli {
namespace {

struct ReverseRequest {
  std::string file;  // empty or "-": standard input
  std::string method = "device";
  std::string input = "freeman";
  int connectivity = 0;  // 0: not given
  bool table = false;
  LineOptions lines;
  Effort effort = Effort::standard;
  bool effort_given = false;
  InputOptions read;
};

constexpr const char* kReverseExamples =
    "  unstep reverse < steps.txt                      'DX DY' per segment\n"
    "  echo 02002002000 | unstep reverse --table       the registers too\n"
    "  unstep interpolate 70 30 | unstep reverse\n"
    "  unstep reverse recording.vcd --channels A,B     encoder pulses\n"
    "  unstep reverse --method exact < steps.txt       'S0 S1 N A W R' per "
    "segment\n"
    "  unstep reverse outline.fc --method tolerance --tolerance 1\n"
    "                                                  few lines and arcs\n"
    "\n"
    "A segment is printed as soon as it is known to end. Codes are 0 (east),\n"
    "1 (north-east), 2 (north) to 7; device and gate-level refuse diagonal\n"
    "steps. Segments of exact give back every step: step i of N is S1 if\n"
    "(A (i + 1) + R) / W, rounded down, exceeds (A i + R) / W, else S0.\n"
    "tolerance reads all steps before it prints; a line is 'DX DY', an arc\n"
    "'DX DY CX CY cw' or 'ccw', its centre relative to its start.\n";

bool takes_file(const ReverseRequest& request) {
  return !request.file.empty() && request.file != "-";
}

ExitCode refuse(ErrorCode code, const std::string& reason) {
  return report_error("standard input", {code, reason});
}

ExitCode cannot_write() {
  return report_error("standard output", {ErrorCode::io_error, "cannot write"});
}

/// Where the reader is, and what it makes of a byte.
class StepReader {
 public:
  /// `straight`: why diagonal steps are refused; nullptr if they are not.
  StepReader(bool text, const char* straight)
      : text_(text), straight_(straight) {}

  enum class Got { nothing, step, error };

  Got take(unsigned char byte, Step& step) {
    ++offset_;
    ++column_;
    if (text_) {
      if (byte == '\n') {
        ++line_;
        column_ = 0;
      }
      if (byte == ' ' || byte == '\t' || byte == '\r' || byte == '\n')
        return Got::nothing;
      if (byte < '0' || byte > '7') return refuse(byte, "no Freeman code 0..7");
      byte = static_cast<unsigned char>(byte - '0');
    } else if (byte > 7) {
      return refuse(byte, "no Freeman code 0..7");
    }
    if (straight_ != nullptr && (byte & 1) != 0)
      return refuse(text_ ? static_cast<unsigned char>(byte + '0') : byte,
                    straight_);
    ++steps_;
    step = byte;
    return Got::step;
  }

  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  Got refuse(unsigned char byte, const char* why) {
    const bool printable = text_ && byte >= ' ' && byte < 0x7F;
    const std::string shown = printable
                                  ? fmt::format("'{}'", static_cast<char>(byte))
                                  : fmt::format("byte 0x{:02x}", byte);
    const std::string place =
        text_ ? fmt::format("line {}, column {}", line_, column_)
              : fmt::format("byte {}", offset_);
    problem_ = fmt::format("{}: {} is {}", place, shown, why);
    return Got::error;
  }

  bool text_;
  const char* straight_;
  std::uint64_t offset_ = 0;
  std::uint64_t line_ = 1;
  std::uint64_t column_ = 0;
  std::uint64_t steps_ = 0;
  std::string problem_;
};

/// The one chain of a file: Freeman text, or a recording of encoders.
Result<Chain> read_chain(const ReverseRequest& request) {
  Result<Source> source = Source::open(request.file, request.read);
  if (!source) return source.error();
  Result<SourcePage> page = source->read(0);
  if (!page) return page.error();
  for (const std::string& note : page->notes) {
    report_warning(request.file, note);
  }
  std::vector<Chain>& chains = page->page.drawing.chains;
  if (chains.size() != 1 || source->page_count() != 1) {
    return Error{ErrorCode::unsupported,
                 fmt::format("holds {} chains on {} pages; reverse takes one",
                             chains.size(), source->page_count())};
  }
  return std::move(chains[0]);
}

/// A file is checked as a whole before anything is printed.
Status check_steps(StepReader reader, const Chain& chain) {
  for (const Step code : chain.steps) {
    Step step = 0;
    if (reader.take(code, step) == StepReader::Got::error) {
      return Error{ErrorCode::corrupt, reader.problem()};
    }
  }
  if (chain.steps.empty()) return Error{ErrorCode::corrupt, "holds no steps"};
  return {};
}

template <class Use>
ExitCode read_file_steps(const StepReader& reader,
                         const ReverseRequest& request, Use use) {
  const Result<Chain> chain = read_chain(request);
  if (!chain) return report_error(request.file, chain.error());
  const Status checked = check_steps(reader, *chain);
  if (!checked) return report_error(request.file, checked.error());
  for (const Step step : chain->steps) use(step);
  return ExitCode::ok;
}

/// Feeds every step of standard input to `use` as it comes; `idle` runs before
/// every read that may wait and says whether to go on.
template <class Use, class Idle>
ExitCode read_steps(StepReader reader, Use use, Idle idle) {
  std::array<unsigned char, 1 << 16> buffer;
  for (;;) {
    if (const ExitCode code = idle(); code != ExitCode::ok) return code;
    const ssize_t n = read(STDIN_FILENO, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0)
      return refuse(ErrorCode::io_error,
                    fmt::format("cannot read: {}", std::strerror(errno)));
    if (n == 0) break;
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
      Step step = 0;
      const StepReader::Got got = reader.take(buffer[i], step);
      if (got == StepReader::Got::error)
        return refuse(ErrorCode::corrupt, reader.problem());
      if (got == StepReader::Got::step) use(step);
    }
  }
  if (reader.steps() == 0) return refuse(ErrorCode::corrupt, "holds no steps");
  return ExitCode::ok;
}

void print_row(Step step, const DeviceRegisters& device) {
  fmt::print("{} {} {} {}\n", step, device.x, device.y, device.f);
}

void print_row(Step step, const GateNet& net) {
  const DeviceRegisters r = net.registers();
  const GateNet::Signals& s = net.signals();
  fmt::print("{} {} {} {} {} {} {} {}\n", step, r.x, r.y, r.f, int{s.and15},
             int{s.and5}, int{s.and16}, int{s.or17});
}

/// All of standard input through `use`, then `finish`. A file is checked as a
/// whole before anything is printed; a stream's segments are out before the
/// stream can turn bad.
template <class Use, class Finish>
ExitCode run(const StepReader& reader, const ReverseRequest& request, Use use,
             Finish finish) {
  if (takes_file(request)) {
    const ExitCode code = read_file_steps(reader, request, use);
    if (code != ExitCode::ok) return code;
    finish();
    return std::fflush(stdout) == 0 ? ExitCode::ok : cannot_write();
  }
  struct stat status {};
  const bool file =
      fstat(STDIN_FILENO, &status) == 0 && S_ISREG(status.st_mode);
  if (file) {
    const off_t start = lseek(STDIN_FILENO, 0, SEEK_CUR);
    const ExitCode checked = read_steps(
        reader, [](Step) {}, [] { return ExitCode::ok; });
    if (checked != ExitCode::ok) return checked;
    lseek(STDIN_FILENO, start, SEEK_SET);
  }
  const auto flush = [file] {
    return file || std::fflush(stdout) == 0 ? ExitCode::ok : cannot_write();
  };
  const ExitCode code = read_steps(reader, use, flush);
  if (code != ExitCode::ok) {
    std::fflush(stdout);
    return code;
  }
  finish();
  if (std::fflush(stdout) != 0) return cannot_write();
  return ExitCode::ok;
}

template <class Device>
ExitCode run_device(const ReverseRequest& request) {
  const StepReader reader(!takes_file(request) && request.input == "freeman",
                          "a diagonal step; the device takes 0, 2, 4 and 6");
  BasicDeviceReverse<Device> device;
  const char* prefix = request.table ? "segment " : "";
  const auto print_segment = [prefix](Segment s) {
    fmt::print("{}{} {}\n", prefix, s.dx, s.dy);
  };
  const auto use = [&](Step step) {
    Segment closed;
    const Pushed pushed = device.push(step, closed);
    // No segment is broken by its first step: one step in the counters means
    // that the segment was closed before this one.
    const DeviceRegisters now = device.device().registers();
    const bool before = now.x + now.y == 1;
    if (pushed == Pushed::segment && before) print_segment(closed);
    if (request.table) print_row(step, device.device());
    if (pushed == Pushed::segment && !before) print_segment(closed);
  };
  return run(reader, request, use, [&] {
    Segment last;
    if (device.finish(last)) print_segment(last);
  });
}

ExitCode run_exact(const ReverseRequest& request) {
  const bool four = request.connectivity == 4;
  const StepReader reader(
      !takes_file(request) && request.input == "freeman",
      four ? "a diagonal step; 4-connected chains have 0, 2, 4 and 6"
           : nullptr);
  ExactReverse exact(four ? Connectivity::four : Connectivity::eight);
  const auto print = [](const char* prefix, const DigitalSegment& s) {
    fmt::print("{}{} {} {} {} {} {}\n", prefix, s.s0, s.s1, s.n, s.a, s.w, s.r);
  };
  const char* prefix = request.table ? "segment " : "";
  const auto use = [&](Step step) {
    DigitalSegment closed;
    if (exact.push(step, closed) == Pushed::segment) print(prefix, closed);
    if (!request.table) return;
    fmt::print("{} ", step);
    print("", exact.open());
  };
  return run(reader, request, use, [&] {
    DigitalSegment last;
    if (exact.finish(last)) print(prefix, last);
  });
}

/// All of standard input, in memory.
ExitCode collect_chain(const ReverseRequest& request, Chain& chain) {
  const DecodeLimits& limits = request.read.limits;
  const std::uint64_t most = std::min(limits.max_steps, limits.max_memory);
  std::uint64_t steps = 0;
  return read_steps(
      StepReader(request.input == "freeman", nullptr),
      [&](Step step) {
        if (++steps <= most) chain.steps.push_back(step);
      },
      [&] {
        if (steps <= most) return ExitCode::ok;
        return refuse(ErrorCode::limit_exceeded,
                      fmt::format("more than {} steps, above {}", most,
                                  limits.max_steps <= limits.max_memory
                                      ? "--max-steps"
                                      : "--max-memory"));
      });
}

ExitCode run_tolerance(const ReverseRequest& request) {
  const bool from_file = takes_file(request);
  const std::string name = from_file ? request.file : "standard input";
  const Result<Rational> tolerance = to_tolerance(request.lines.tolerance, {});
  if (!tolerance) {
    return report_usage("reverse", "--tolerance: " + tolerance.error().message);
  }
  Chain chain;
  chain.connectivity = Connectivity::eight;
  if (from_file) {
    Result<Chain> read = read_chain(request);
    if (!read) return report_error(name, read.error());
    chain = *std::move(read);
    const Status checked = check_steps(StepReader(false, nullptr), chain);
    if (!checked) return report_error(name, checked.error());
  } else {
    const ExitCode code = collect_chain(request, chain);
    if (code != ExitCode::ok) return code;
  }
  ToleranceOptions options{*tolerance, request.effort, request.lines.arcs};
  const Status printed = print_lines(std::move(chain), options, request.table);
  if (printed) return ExitCode::ok;
  if (printed.error().code == ErrorCode::out_of_range) {
    return report_usage("reverse", "--" + printed.error().message);
  }
  return report_error(
      printed.error().code == ErrorCode::io_error ? "standard output" : name,
      printed.error());
}

ExitCode reverse_verb(const ReverseRequest& request) {
  const auto usage = [](const std::string& reason) {
    return report_usage("reverse", reason);
  };
  if (request.input != "freeman" && request.input != "bytes")
    return usage(
        fmt::format("unknown input '{}': freeman or bytes", request.input));
  const bool tolerance = request.method == "tolerance";
  const bool within = request.lines.method == LineOptions::Method::tolerance;
  if (tolerance != within) {
    return usage(tolerance ? "--method tolerance needs --tolerance E"
                           : "--tolerance is for --method tolerance");
  }
  if (tolerance && request.connectivity == 0) return run_tolerance(request);
  if (!tolerance && request.effort_given) {
    return usage("--effort is for --method tolerance");
  }
  if (request.method == "exact") {
    if (request.connectivity != 0 && request.connectivity != 4 &&
        request.connectivity != 8)
      return usage(
          fmt::format("--connectivity {}: 4 or 8", request.connectivity));
    return run_exact(request);
  }
  if (!tolerance && request.method != "device" &&
      request.method != "gate-level")
    return usage(fmt::format(
        "unknown method '{}': device, gate-level, exact or tolerance",
        request.method));
  if (request.connectivity != 0)
    return usage("--connectivity is for --method exact");
  return request.method == "device" ? run_device<DeviceRegisters>(request)
                                    : run_device<GateNet>(request);
}

}  // namespace

void add_reverse(CLI::App& app, Context& context) {
  auto request = std::make_shared<ReverseRequest>();
  CLI::App* verb =
      app.add_subcommand("reverse", "Turn unit steps into segments");
  verb->add_option("IN", request->file,
                   "A file of one chain: Freeman text, or a recording of "
                   "encoders (.csv, .vcd, .sr) [steps from standard input]")
      ->type_name("");
  verb->add_option("--method", request->method,
                   "device (SU 1089551), gate-level, the same as a net, "
                   "exact: the longest digital straight segments, or "
                   "tolerance: few lines and arcs [device]")
      ->type_name("NAME");
  verb->add_option("--input", request->input,
                   "freeman: digits, white space ignored; bytes: 0 to 7 "
                   "[freeman]")
      ->type_name("FORM");
  verb->add_option("--connectivity", request->connectivity,
                   "exact: which codes are neighbours and may share a "
                   "segment: 8, or 4 for chains of 0, 2, 4 and 6 [8]")
      ->type_name("N");
  add_tolerance(*verb, request->lines,
                "tolerance: lines and arcs are nowhere farther than this from "
                "the steps, in grid units, 1/256 and more");
  add_effort(*verb, request->effort)->each([request](const std::string&) {
    request->effort_given = true;
  });
  verb->add_flag("--table", request->table,
                 "A row per step: step X Y F, and 'segment DX DY' lines; "
                 "exact: step S0 S1 N A W R; tolerance: X Y, where a line or "
                 "arc starts, before it");
  add_decoding(*verb, request->read.decoding);
  add_limits(*verb, request->read.limits);
  finish_verb(*verb, kReverseExamples);
  verb->callback([request, &context] {
    context.run = [request] { return reverse_verb(*request); };
  });
}

}  // namespace unstep::cli
