#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "unstep/program.h"

namespace unstep {
namespace {

using Kind = ProgramItem::Kind;

Program read(const std::string& text, GcodeReadOptions options = {}) {
  Result<Program> program = read_gcode(text, options);
  EXPECT_TRUE(program) << text << ": "
                       << (program ? "" : program.error().message);
  return program ? *program : Program{};
}

std::string error_of(const std::string& text, GcodeReadOptions options = {}) {
  const Result<Program> program = read_gcode(text, options);
  return program ? "none" : program.error().message;
}

std::string strict_error(const std::string& text) {
  GcodeReadOptions options;
  options.strict = true;
  return error_of(text, options);
}

/// "kind x y z" of every motion, in mm.
std::string moves(const std::string& text) {
  const Program program = read(text);
  const auto made = program_moves(program, true);
  std::string out;
  for (const ProgramMove& move : *made) {
    constexpr std::string_view kNames = "tRLAC";
    out += kNames[static_cast<std::size_t>(move.kind)];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto number = static_cast<double>(move.end[axis]) / 1e7;
      std::string digits = std::to_string(number);
      while (digits.back() == '0') digits.pop_back();
      if (digits.back() == '.') digits.pop_back();
      out += " " + digits;
    }
    out += ";";
  }
  return out;
}

TEST(gcode_reader, modal_words_stay_in_force) {
  EXPECT_EQ(moves("G21 G90\nG0 X1 Y2\nG01 Z-.5 F100\nX3\nY-4.25\n"),
            "R 1 2 0;L 1 2 -0.5;L 3 2 -0.5;L 3 -4.25 -0.5;");
}

TEST(gcode_reader, letter_case_and_blanks_mean_nothing) {
  EXPECT_EQ(moves("g0x1y 2z - 3\n  G 1 X  0.5\tF10\r\n"),
            "R 1 2 -3;L 0.5 2 -3;");
}

TEST(gcode_reader, inches_are_exact) {
  const Program program = read("G20\nG0 X1 Y0.000001\n");
  EXPECT_EQ(program.items[1].end[0], 254'000'000);
  EXPECT_EQ(program.items[1].end[1], 254);
}

TEST(gcode_reader, incremental_words_add_up_without_drift) {
  std::string text = "G21 G90 G0 X0 Y0 Z0\nG91 G1 F100 X0.1\n";
  for (int i = 1; i < 1000; ++i) text += "X0.1\n";
  const Program program = read(text);
  EXPECT_EQ(program.items.back().end[0], 100 * kProgramUnitsPerMm);
}

TEST(gcode_reader, offsets_move_the_machine_not_the_program) {
  EXPECT_EQ(moves("G0 X1\nG92 X5\nG1 X6 F9\nG92.1\nX3\n"),
            "R 1 0 0;L 2 0 0;L 3 0 0;");
  EXPECT_EQ(moves("G10 L2 P2 X10\nG55 G0 X1\nG54 X1\n"), "R 11 0 0;R 1 0 0;");
  EXPECT_EQ(moves("G10 L2 P2 X10\nG55 G0 X1\nG53 G0 X2\nX2\n"),
            "R 11 0 0;R 2 0 0;R 12 0 0;");
}

TEST(gcode_reader, arcs_have_their_centre_by_words_or_by_radius) {
  for (const char* text :
       {"G0 X0 Y0\nG2 X10 Y0 I5 J0 F9\n", "G0 X0 Y0\nG2 X10 Y0 R5 F9\n",
        "G90.1\nG0 X0 Y0\nG2 X10 Y0 I5 J0 F9\n"}) {
    const Program program = read(text);
    const ProgramItem& arc = program.items.back();
    EXPECT_EQ(arc.kind, Kind::clockwise) << text;
    EXPECT_EQ(arc.centre[0], 5 * kProgramUnitsPerMm) << text;
    EXPECT_EQ(arc.centre[1], 0) << text;
  }
  const Program major = read("G0 X0 Y0\nG3 X6 Y0 R-5 F9\n");
  EXPECT_EQ(major.items.back().centre[1], -4 * kProgramUnitsPerMm);
  const Program minor = read("G0 X0 Y0\nG2 X6 Y0 R5 F9\n");
  EXPECT_EQ(minor.items.back().centre[1], -4 * kProgramUnitsPerMm);
}

TEST(gcode_reader, arcs_lie_in_the_plane_in_force) {
  const Program program = read("G18\nG0 X0 Y0 Z0\nG2 X4 Z0 I2 K0 Y1 F9\n");
  const ProgramItem& arc = program.items.back();
  EXPECT_EQ(arc.centre[0], 0);  // z first
  EXPECT_EQ(arc.centre[1], 2 * kProgramUnitsPerMm);
  EXPECT_EQ(arc.end[1], kProgramUnitsPerMm);
}

TEST(gcode_reader, a_full_circle_ends_where_it_starts) {
  const Program program = read("G0 X1 Y1\nG3 I2 F9\n");
  EXPECT_EQ(program.items.back().kind, Kind::counter);
  EXPECT_EQ(program.items.back().end, program.items.front().end);
}

TEST(gcode_reader, expressions_follow_rs274) {
  EXPECT_EQ(
      moves("#1=1\n#1=2 #<a b>=[#1+1]\n#1=[#1+5]\nG0 X#1 Y#<AB> Z[2**3*2]\n"),
      "R 7 2 16;");  // a line's values are read before it sets any
  EXPECT_EQ(moves("G0 X[1+2*3] Y[[1+2]*3] Z-[7 mod 4]\n"), "R 7 9 -3;");
  EXPECT_EQ(moves("G0 X[atan[1]/[1]] Y[cos[60]] Z[fix[-2.5]+fup[2.1]]\n"),
            "R 45 0.5 0;");
  EXPECT_EQ(moves("#2=7\n#7=3\nG0 X##2 Y-#7\n"), "R 3 -3 0;");
}

TEST(gcode_reader, values_the_program_does_not_set_are_not_guessed) {
  const Program program = read("G0 X1\nG1 X#5 F9\nX2\nG21 G90 G1 X3\n");
  EXPECT_TRUE(program.items[1].unknown_effect);
  EXPECT_EQ(program.items[2].kind, Kind::text);  // no motion mode is known
  EXPECT_EQ(program.items[3].kind, Kind::line);
  EXPECT_EQ(program.notes.size(), 2U);
  EXPECT_EQ(strict_error("G0 X1\nG1 X#5 F9\n"),
            "line 2: a parameter that the program does not set is not "
            "understood");
}

TEST(gcode_reader, unknown_words_leave_nothing_known) {
  const Program program = read("G21 G90 G1 X1 Y1 F9\nM123\nX2\nG1 X3\n");
  const ProgramItem& after = program.items[1];
  EXPECT_TRUE(after.unknown_effect);
  EXPECT_EQ(after.known, 0);
  EXPECT_FALSE(program.modes[after.modes].inches.has_value());
  EXPECT_EQ(program.items[2].kind, Kind::text);
  EXPECT_EQ(program.items[3].kind, Kind::text);
  EXPECT_FALSE(program_moves(program));
  EXPECT_EQ(strict_error("G1 X1 F9\nM123\n"), "line 2: M123 is not understood");
}

TEST(gcode_reader, known_barriers_keep_what_is_certain) {
  for (const char* word : {"G61", "G64 P0.1", "G40", "M8", "M6 T1", "G4 P1"}) {
    const Program program =
        read(std::string("G21 G90 G1 X1 Y1 Z0 F9\n") + word + "\nX2 Y2\n");
    EXPECT_FALSE(program.items[1].unknown_effect) << word;
    EXPECT_EQ(program.items[2].kind, Kind::line) << word;
  }
  // A tool change may have moved the machine.
  EXPECT_EQ(read("G1 X1 F9\nM6 T1\n").items[1].known, 0);
  // Compensated and inverse-time motions stay as they are written.
  EXPECT_TRUE(read("G1 X1 F9\nG41 D1\nX2\n").items[2].keep_text);
  EXPECT_TRUE(read("G1 X1 F9\nG93\nX2 F3\n").items[2].keep_text);
  EXPECT_TRUE(read("G0 X0 Y0\nG2 I1 P3 F9\n").items[1].keep_text);
  EXPECT_EQ(read("G0 X0 Y0\nG2 I1 P3 F9\n").items[1].turns, 3U);
}

TEST(gcode_reader, canned_cycles_and_homing_lose_the_position) {
  for (const char* line : {"G81 X1 Y1 Z-1 R2 F9", "G28 X0", "G28", "G38.2 Z-5",
                           "G10 L20 P1 X0", "G92.3"}) {
    const Program program = read(std::string("G0 X1 Y1 Z1\n") + line + "\n");
    EXPECT_TRUE(program.items[1].unknown_effect) << line;
    EXPECT_EQ(program.items[1].known & 1, 0) << line;
  }
}

TEST(gcode_reader, block_delete_is_an_option) {
  GcodeReadOptions options;
  EXPECT_TRUE(read("/G0 X1\n").items[0].unknown_effect);
  options.block_delete = GcodeReadOptions::BlockDelete::execute;
  EXPECT_EQ(read("/G0 X1\n", options).items[0].kind, Kind::rapid);
  options.block_delete = GcodeReadOptions::BlockDelete::skip;
  EXPECT_TRUE(read("/G0 X1\n", options).items.empty());
}

TEST(gcode_reader, comments_keep_their_place) {
  const Program program =
      read("(head)\nG0 X1 (to one) ; and so\n; tail\n(MSG, hello)\n");
  ASSERT_EQ(program.items.size(), 6U);
  EXPECT_EQ(program.text_of(program.items[0]), "(head)");
  EXPECT_EQ(program.text_of(program.items[1]), "(to one)");
  EXPECT_EQ(program.text_of(program.items[2]), "; and so");
  EXPECT_EQ(program.items[3].kind, Kind::rapid);
  EXPECT_EQ(program.text_of(program.items[5]), "(MSG, hello)");
}

TEST(gcode_reader, checksums_are_verified_and_dropped) {
  // 0x47 ^ 0x31 and so on, as a printer's host sends them.
  const std::string line = "N1 M105 ";
  unsigned sum = 0;
  for (const char c : line) sum ^= static_cast<unsigned char>(c);
  const Program program = read(line + "*" + std::to_string(sum) + "\n");
  EXPECT_EQ(program.text_of(program.items[0]), "M105");
  const Result<Program> wrong =
      read_gcode(line + "*" + std::to_string(sum ^ 1) + "\n", {});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, ErrorCode::checksum_mismatch);
}

TEST(gcode_reader, extrusion_and_other_axes_are_carried) {
  const Program program =
      read("M82\nG1 X1 A45 E0.5 F9\nM83\nG1 X2 E0.25\nG92 E0\nG1 X3 E1\n");
  EXPECT_EQ(program.position(program.items[1])[3], 45 * kProgramUnitsPerMm);
  EXPECT_EQ(program.position(program.items[3])[9], 7'500'000);
  EXPECT_EQ(program.position(program.items[5])[9], 10'000'000);
}

TEST(gcode_reader, nothing_after_the_end_is_carried_out) {
  EXPECT_EQ(moves("G0 X1\nM2\nG0 X2\n"), "R 1 0 0;");
  EXPECT_EQ(moves("%\nG0 X1\n%\nG0 X2\n"), "R 1 0 0;");
}

TEST(gcode_reader, errors_name_the_line_and_the_reason) {
  EXPECT_EQ(error_of("G0 X1\nG1 X F9\n"), "line 2: expected a number after X");
  EXPECT_EQ(error_of("G1 X1.2.3\n"), "line 1: a number with two points");
  EXPECT_EQ(error_of("G1 X--1\n"), "line 1: a number with two signs");
  EXPECT_EQ(error_of("G1 X1 X2\n"), "line 1: X stands twice on the line");
  EXPECT_EQ(error_of("G0 G1 X2\n"),
            "line 1: G1 and another word of its group on one line");
  EXPECT_EQ(error_of("\n\nG1 X1 (open\n"), "line 3: a comment is not closed");
  EXPECT_EQ(error_of("G0 X0 Y0\nG2 X1 Y1 F9\n"),
            "line 2: arc: neither a radius nor a centre");
  EXPECT_EQ(error_of("G0 X0 Y0\nG2 X10 Y0 I5.5 F9\n"),
            "line 2: arc: its radius is 5.5000 mm at the start and 4.5000 mm "
            "at the end, 1.0000 mm apart");
  EXPECT_EQ(error_of("G0 X0 Y0\nG2 X10 Y0 R4 F9\n"),
            "line 2: arc: a radius of 4.0000 mm does not reach an end 10.0000 "
            "mm away");
  EXPECT_EQ(error_of("G0 X0 Y0\nG2 X0 Y0 R4 F9\n"),
            "line 2: arc: with R it cannot end where it starts");
  EXPECT_EQ(error_of("G0 X0 Y0\nG2 X1 K1 I1 F9\n"),
            "line 2: arc: K is not of its plane");
  EXPECT_EQ(error_of("G1 X[1/0]\n"), "line 1: division by zero");
  EXPECT_EQ(error_of("G1 X[1 + ]\n"), "line 1: expected a number");
  EXPECT_EQ(error_of("G1 X[1 + 2\n"), "line 1: expected \"]\"");
  EXPECT_EQ(error_of("G1 X999999999\n"), "line 1: X beyond 100 km");
  EXPECT_EQ(error_of("G1 X99999999999999\n"), "line 1: number too large");
  EXPECT_EQ(error_of("G1 \x01\n"), "line 1: expected a letter, not byte 0x01");
}

TEST(gcode_reader, limits_come_before_memory) {
  GcodeReadOptions options;
  options.limits.max_line_bytes = 100;
  EXPECT_EQ(error_of("G0 X1\n(" + std::string(200, 'x') + ")\n", options),
            "line 2: longer than the limit of 100 bytes");
  options = {};
  options.limits.max_memory = 10'000;
  std::string many;
  for (int i = 0; i < 1000; ++i) many += "G0 X" + std::to_string(i) + "\n";
  EXPECT_NE(error_of(many, options).find("more than the memory limit"),
            std::string::npos);
  options = {};
  options.limits.max_bytes = 10;
  EXPECT_EQ(error_of(many, options), "more than the limit of 10 bytes");
  EXPECT_NE(
      error_of("G0 X" + std::string(2000, '[') + "1\n").find("nested too deep"),
      std::string::npos);
}

TEST(gcode_reader, offsets_cannot_add_up_beyond_the_range) {
  std::string text;
  for (int i = 0; i < 10000; ++i) text += "G92 X0\nG1 X99999999 F9\n";
  EXPECT_NE(error_of(text).find("offsets lead beyond 100 km"),
            std::string::npos);
}

}  // namespace
}  // namespace unstep
