#pragma once

#include <string>

#include "unstep/program.h"

namespace unstep {

/// Appends a word with its number, rounded to so many decimals.
void append_gcode_number(std::string& out, const char* word, double value,
                         int decimals);

/// The lines of a drawn program that are about its tool, as the profile and the
/// user's own lines say.
class GcodeTool {
 public:
  /// `out` must outlive the tool.
  GcodeTool(const DrawProgramOptions& options, std::string& out);

  void begin();  ///< of the program
  void end();
  void on();  ///< before a path
  void off();

 private:
  void own_lines(const std::string& lines);
  void number(const char* word, double value, int decimals) {
    append_gcode_number(out_, word, value, decimals);
  }

  const DrawProgramOptions& options_;
  std::string& out_;
  double cut_z_;
  bool laser_;
  bool lifts_;
};

}  // namespace unstep
