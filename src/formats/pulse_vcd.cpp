#include <cmath>
#include <utility>

#include "formats/pulse_chain.h"
#include "formats/vcd_reader.h"

/// Encoder channels of a value change dump.
namespace unstep {
namespace {

Result<std::vector<VcdProbe>> choose(const VcdReader& file,
                                     const PulseReadOptions& options) {
  std::vector<VcdProbe> probes;
  if (options.channels.empty()) {
    std::vector<std::string> names;
    std::vector<VcdProbe> all;
    for (const VcdSignal& signal : file.signals()) {
      if (signal.width != 1) continue;
      names.push_back(signal.name);
      all.push_back({signal.net, 0});
    }
    const auto chosen = choose_channels(names, {});
    if (!chosen) return chosen.error();
    for (const std::size_t i : *chosen) probes.push_back(all[i]);
    return probes;
  }
  if (options.channels.size() != 2 && options.channels.size() != 4) {
    return Error{ErrorCode::invalid_argument,
                 "two channels or four are needed, not " +
                     std::to_string(options.channels.size())};
  }
  for (const std::string& name : options.channels) {
    const Result<VcdProbe> probe = file.find(name);
    if (!probe) return probe.error();
    probes.push_back(*probe);
  }
  return probes;
}

/// The levels of the channels, change by change.
class Levels {
 public:
  explicit Levels(std::vector<VcdProbe> probes) : probes_(std::move(probes)) {}

  /// True if the change is of one of the channels.
  bool take(const VcdChange& change) {
    bool ours = false;
    for (std::size_t i = 0; i < probes_.size(); ++i) {
      if (probes_[i].net != change.net) continue;
      ours = true;
      const std::optional<bool> level = probes_[i].level(change);
      const unsigned bit = 1U << i;
      if (!level) {
        if ((known_ & bit) != 0) ++lost_;
        continue;
      }
      known_ |= bit;
      levels_ = *level ? levels_ | bit : levels_ & ~bit;
    }
    return ours;
  }

  [[nodiscard]] unsigned levels() const { return levels_; }
  [[nodiscard]] unsigned known() const { return known_; }
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

 private:
  std::vector<VcdProbe> probes_;
  unsigned levels_ = 0;
  unsigned known_ = 0;
  std::uint64_t lost_ = 0;  ///< changes to x or z
};

std::string when(const VcdTimescale& scale, std::uint64_t time) {
  if (!scale.known) return "time " + std::to_string(time);
  return time_text(static_cast<double>(time) * scale.magnitude *
                   std::pow(10.0, scale.exponent));
}

}  // namespace

Result<VectorPage> read_pulse_vcd(std::string_view text,
                                  const PulseReadOptions& options) {
  Result<VcdReader> file = VcdReader::open(text, options.limits);
  if (!file) return file.error();
  Result<std::vector<VcdProbe>> probes = choose(*file, options);
  if (!probes) return probes.error();
  PulseChain chain(options, probes->size());
  Levels levels(*std::move(probes));
  std::uint64_t time = 0;
  bool pending = false;
  // What changes at one time changes together.
  const auto sample = [&]() -> Status {
    if (!std::exchange(pending, false)) return {};
    const Result<bool> illegal = chain.sample(levels.levels(), levels.known());
    if (!illegal) {
      return Error{illegal.error().code, when(file->timescale(), time) + ": " +
                                             illegal.error().message};
    }
    if (*illegal) chain.note_illegal(when(file->timescale(), time));
    return {};
  };
  for (;;) {
    const auto change = file->next();
    if (!change) return change.error();
    if (!*change || (*change)->time != time) {
      if (Status done = sample(); !done) return done.error();
    }
    if (!*change) break;
    time = (*change)->time;
    if (levels.take(**change)) pending = true;
  }
  VectorPage page = chain.finish("vcd");
  if (levels.lost() > 0) {
    page.notes.push_back("a channel is unknown (x or z) " +
                         std::to_string(levels.lost()) +
                         " times; its last level is kept");
  }
  return page;
}

}  // namespace unstep
