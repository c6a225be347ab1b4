#include "cli/interpolate_output.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace unstep::cli {
namespace {

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
                TickForm form) {
  std::array<Register, kMaxRegisters> registers;
  const std::size_t count = run.registers(registers);
  if (form == TickForm::csv) {
    out.print("tick,kind,step,dx,dy");
    for (std::size_t i = 0; i < count; ++i) out.print(",{}", registers[i].name);
    out.print("\n");
  }
  if (form == TickForm::json)
    out.print("{{\"method\":\"{}\",\"tag\":\"{}\",\"ticks\":[", info.name,
              info.tag);
  std::uint64_t number = 0;
  for (Tick t = run.next(); t.kind != Tick::Kind::done && out.good();
       t = run.next()) {
    ++number;
    run.registers(registers);
    if (form == TickForm::table) {
      write_move(out, t, info);
      for (std::size_t i = 0; i < count; ++i)
        out.print(" {}", registers[i].value);
      out.print("\n");
      continue;
    }
    const std::string step =
        t.kind == Tick::Kind::step ? fmt::format("{}", t.step) : "";
    if (form == TickForm::csv) {
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
  if (form == TickForm::json) out.print("\n]}}\n");
}

}  // namespace

bool write_ticks(Interpolator& run, const MethodInfo& info, TickForm form) {
  Writer out;
  if (form == TickForm::steps) {
    write_steps(out, run, info);
  } else {
    write_rows(out, run, info, form);
  }
  return out.finish();
}

}  // namespace unstep::cli
