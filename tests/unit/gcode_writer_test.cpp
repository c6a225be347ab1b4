#include <gtest/gtest.h>

#include <string>

#include "unstep/program.h"

namespace unstep {
namespace {

std::string rewrite(const std::string& text, GcodeWriteOptions options = {},
                    GcodeReadOptions read = {}) {
  const Result<Program> program = read_gcode(text, read);
  EXPECT_TRUE(program) << text;
  if (!program) return {};
  const Result<std::string> out = write_gcode(*program, options);
  EXPECT_TRUE(out);
  return out ? *out : std::string();
}

TEST(gcode_writer, words_stand_only_where_they_change_something) {
  EXPECT_EQ(rewrite("G21 G90\nG00 X1.000 Y2.50\nG00 Z0\nG01 X3.0 Y2.5 F100\n"
                    "G01 X3 Y4 F100\nM2\n"),
            "G21 G90\nG0 X1 Y2.5\nZ0\nG1 X3 F100\nY4\nM2\n");
}

TEST(gcode_writer, a_motion_that_goes_nowhere_stays) {
  EXPECT_EQ(rewrite("G0 X1 Y1\nG1 Y1 F9\nM2\n"), "G0 X1 Y1\nG1 Y1 F9\nM2\n");
  EXPECT_EQ(rewrite("G91\nG0 X0\nM2\n"), "G91\nG0 X0\nM2\n");
}

TEST(gcode_writer, incremental_programs_stay_so) {
  EXPECT_EQ(rewrite("G0 X1 Y1\nG91\nG1 X.5 F9\nX.5 Y-2\nG90\nX0\nM2\n"),
            "G0 X1 Y1\nG91\nG1 X0.5 F9\nX0.5 Y-2\nG90\nX0\nM2\n");
}

TEST(gcode_writer, arcs_have_the_asked_form) {
  const std::string text = "G0 X0 Y0\nG2 X2 R1 F9\nG3 X4 I1\nM2\n";
  GcodeWriteOptions options;
  EXPECT_EQ(rewrite(text, options), "G0 X0 Y0\nG2 X2 R1 F9\nG3 X4 I1\nM2\n");
  options.arcs = GcodeWriteOptions::ArcForm::centre;
  EXPECT_EQ(rewrite(text, options), "G0 X0 Y0\nG2 X2 I1 F9\nG3 X4 I1\nM2\n");
  options.arcs = GcodeWriteOptions::ArcForm::radius;
  EXPECT_EQ(rewrite(text, options),
            "G0 X0 Y0\nG2 X1 Y1 R1 F9\nX2 Y0 R1\nG3 X3 Y-1 R1\nX4 Y0 R1\n"
            "M2\n");
}

TEST(gcode_writer, absolute_centres_are_kept) {
  EXPECT_EQ(rewrite("G90.1\nG0 X1 Y0\nG2 X3 I2 J0 F9\nM2\n"),
            "G90.1\nG0 X1 Y0\nG2 X3 I2 J0 F9\nM2\n");
}

TEST(gcode_writer, units_are_converted_and_brought_back_for_text) {
  GcodeWriteOptions options;
  options.inches = true;
  EXPECT_EQ(rewrite("G21\nG0 X25.4 Y50.8\nM123 P5\nM2\n", options),
            "G21\nG20 G0 X1 Y2\nG21\nM123 P5\nM2\n");
  options.inches = false;
  EXPECT_EQ(rewrite("G20\nG1 X1 F10\nX2 F20\nM2\n", options),
            "G20\nG21 G1 X25.4 F254\nX50.8 F508\nG20\nM2\n");
}

TEST(gcode_writer, text_finds_feed_and_spindle_as_they_were) {
  const std::string text = "G1 X1 F100 S500\nX1\nS600\nG4 P1\nX2\nM2\n";
  EXPECT_EQ(rewrite(text), "G1 X1 F100 S500\nX1\nS600\nG4 P1\nX2\nM2\n");
}

TEST(gcode_writer, nothing_is_left_out_after_what_is_not_understood) {
  EXPECT_EQ(rewrite("G21 G90 G17\nG1 X1 Y1 F9\nM123\nG1 X1 Y1\nG21 G90\n"
                    "G1 X1 Y1 F9\nX1 Y2\nM2\n"),
            "G21 G90 G17\nG1 X1 Y1 F9\nM123\nG1 X1 Y1\nG21 G90\n"
            "G1 X1 Y1 F9\nX1 Y2\nM2\n");
}

TEST(gcode_writer, profiles_differ_where_controls_do) {
  const std::string text = "(note)\nG0 X1\nX2\n";
  GcodeWriteOptions options;
  EXPECT_EQ(rewrite(text, options), "(note)\nG0 X1\nX2\nM2\n");
  options.profile = GcodeProfile::marlin;
  EXPECT_EQ(rewrite(text, options), ";note\nG0 X1\nG0 X2\n");
  options.profile = GcodeProfile::grbl;
  options.blanks = false;
  EXPECT_EQ(rewrite("G0 X1 Y2\nM2\n", options), "G0X1Y2\nM2\n");
}

TEST(gcode_writer, header_and_footer_stand_inside_the_ends) {
  GcodeWriteOptions options;
  options.header = "G64 P0.01";
  options.footer = "M5\nM9";
  EXPECT_EQ(rewrite("%\nG0 X1\nM30\n%\n", options),
            "%\nG64 P0.01\nG0 X1\nM5\nM9\nM30\n%\n");
  EXPECT_EQ(rewrite("G0 X1\n%\n", options), "G64 P0.01\nG0 X1\nM5\nM9\nM2\n");
}

TEST(gcode_writer, decimals_round_without_drift) {
  GcodeWriteOptions options;
  options.decimals = 1;
  std::string text = "G0 X0 Y0\nG91\nG1 X0.04 F9\n";
  for (int i = 0; i < 4; ++i) text += "X0.04\n";
  EXPECT_EQ(rewrite(text + "M2\n", options),
            "G0 X0 Y0\nG91\nG1 X0 F9\nX0.1\nX0\nX0.1\nX0\nM2\n");
}

TEST(gcode_writer, limits_of_the_range_are_written_and_read_again) {
  for (const char* unit : {"G21", "G20"}) {
    const std::string most = unit[2] == '1' ? "100000000" : "3937007.874015";
    const std::string text =
        std::string(unit) + "\nG0 X" + most + " Y-" + most + "\nM2\n";
    EXPECT_EQ(rewrite(text), text);
  }
}

TEST(split_arcs, quadrants_end_at_the_extremes) {
  const Result<Program> program =
      read_gcode("G0 X3 Y4\nG2 X3 Y4 I-3 J-4 F9\nM2\n", {});
  ArcRules rules;
  rules.quadrants = true;
  const Result<Program> split = split_arcs(*program, rules);
  ASSERT_TRUE(split);
  EXPECT_EQ(*write_gcode(*split, {}),
            "G0 X3 Y4\nG2 X5 Y0 I-3 J-4 F9\nX0 Y-5 I-5\nX-5 Y0 J5\n"
            "X0 Y5 I5\nX3 Y4 J-5\nM2\n");
}

}  // namespace
}  // namespace unstep
