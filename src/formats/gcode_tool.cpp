#include "formats/gcode_tool.h"

#include <cmath>

#include "formats/gcode_number.h"

namespace unstep {

void append_gcode_number(std::string& out, const char* word, double value,
                         int decimals) {
  out += word;
  append_number(
      out, round_number(std::llround(value * kProgramUnitsPerMm), decimals));
}

GcodeTool::GcodeTool(const DrawProgramOptions& options, std::string& out)
    : options_(options), out_(out) {
  const bool pen = options.profile == GcodeProfile::plotter ||
                   options.profile == GcodeProfile::marlin;
  cut_z_ = options.cut_z > -1e9 ? options.cut_z : pen ? 0 : -1;
  laser_ = options.profile == GcodeProfile::laser;
  lifts_ = !laser_ && options.tool_on.empty();
}

void GcodeTool::own_lines(const std::string& lines) {
  if (lines.empty()) return;
  out_ += lines;
  if (out_.back() != '\n') out_ += '\n';
}

void GcodeTool::begin() {
  out_ += options_.profile == GcodeProfile::marlin ? "G21 G90\n"
                                                   : "G21 G90 G17 G94\n";
  if (laser_ && options_.tool_off.empty()) out_ += "M5\n";
  if (lifts_) number("G0 Z", options_.travel_z, 4), out_ += '\n';
  const bool spins = !laser_ && options_.spindle > 0;
  if (spins) number("M3 S", options_.spindle, 3), out_ += '\n';
  if (!options_.tool_off.empty()) own_lines(options_.tool_off);
}

void GcodeTool::end() {
  if (!laser_ && options_.spindle > 0) out_ += "M5\n";
}

void GcodeTool::on() {
  if (!options_.tool_on.empty()) return own_lines(options_.tool_on);
  if (laser_) {
    number("M3 S", options_.power, 3);
  } else {
    number("G1 Z", cut_z_, 4);
    number(" F", options_.plunge_feed, 4);
  }
  out_ += '\n';
}

void GcodeTool::off() {
  if (!options_.tool_off.empty()) return own_lines(options_.tool_off);
  if (laser_) {
    out_ += "M5\n";
  } else if (lifts_) {
    number("G0 Z", options_.travel_z, 4);
    out_ += '\n';
  }
}

}  // namespace unstep
