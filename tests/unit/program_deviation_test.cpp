#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "unit/program_oracle.h"
#include "unstep/deviation.h"

namespace unstep {
namespace {

Program read(const std::string& text) {
  const Result<Program> program = read_gcode(text, {});
  EXPECT_TRUE(program) << text;
  return program ? *program : Program{};
}

ProgramDeviation measured(const std::string& first, const std::string& second,
                          double limit = 10) {
  const auto found =
      measure_program_deviation(read(first), read(second), limit);
  EXPECT_TRUE(found) << (found ? "" : found.error().message);
  return found ? *found : ProgramDeviation{};
}

std::string difference(const std::string& first, const std::string& second) {
  const auto found = measure_program_deviation(read(first), read(second), 1);
  return found ? "none" : found.error().message;
}

void expect_distance(const ProgramDeviation& found, double distance) {
  EXPECT_LE(found.least, distance);
  EXPECT_GE(found.distance, distance);
  EXPECT_LE(found.distance - found.least, 5e-6);
}

TEST(program_deviation, is_that_of_the_paths_in_space) {
  const std::string straight = "G0 X0 Y0 Z0\nG1 X10 F100\n";
  expect_distance(measured(straight, straight), 0);
  expect_distance(
      measured("G0 X0 Y0 Z0\nG1 X5 Y0.3 Z-0.4 F100\nX10 Y0 Z0\n", straight),
      0.5);
  const ProgramDeviation there =
      measured("G0 X0 Y0 Z0\nG1 X2 F100\n(a)\nX5 Y0.25\nX10 Y0\n", straight);
  expect_distance(there, 0.25);
  EXPECT_EQ(there.line, 4U);
  EXPECT_NEAR(there.at[0], 5, 1e-9);
}

TEST(program_deviation, follows_the_order_of_travel) {
  // Every point is on the other path, but going back is left out.
  expect_distance(
      measured("G0 X0 Y0\nG1 X8 F9\nX2\nX10\n", "G0 X0 Y0\nG1 X10 F9\n"), 3);
}

TEST(program_deviation, knows_arcs_of_every_plane) {
  const std::string arc = "G0 X0 Y0 Z0\nG18\nG3 X20 Z0 I10 F100\n";
  std::string chords = "G0 X0 Y0 Z0\nG1";
  for (int i = 1; i <= 12; ++i) {
    const double angle = 3.14159265358979 * (1 - i / 12.0);
    chords += " X" + std::to_string(10 + 10 * std::cos(angle)) + " Z" +
              std::to_string(10 * std::sin(angle)) + " F100\n";
  }
  const double sagitta = 10 * (1 - std::cos(3.14159265358979 / 24));
  EXPECT_NEAR(measured(arc, chords).distance, sagitta, 1e-5);
  EXPECT_NEAR(measured(chords, arc).distance, sagitta, 1e-5);
  expect_distance(
      measured("G0 X0 Y0\nG3 I5 Z8 P2 F9\n", "G0 X0 Y0\nG3 I5 Z8 P2 F9\n"), 0);
}

TEST(program_deviation, measures_where_rapids_end) {
  expect_distance(measured("G0 X0\nG0 X5.002\n", "G0 X0\nX5\n"), 0.002);
}

TEST(program_deviation, refuses_what_is_no_shorter_form) {
  const std::string base = "G0 X0\nM3 S100\nG1 X1 F100\nX2 E1\n";
  EXPECT_EQ(difference(base, "G0 X0\nM3 S100\nG1 X2 F200 E1\n"),
            "line 3 of the first has another feed than line 3 of the second");
  EXPECT_EQ(difference(base, "G0 X0\nM3 S90\nG1 X2 F100 E1\n"),
            "line 3 of the first has another spindle word than line 3 of the "
            "second");
  EXPECT_EQ(difference(base, "G0 X0\nM3 S100\nG1 X2 F100 E2\n"),
            "line 3 of the first has another end of E than line 3 of the "
            "second");
  EXPECT_EQ(difference(base, "G1 X0 F100\nX2 E1\n"),
            "line 1 of the first has another kind of motion than line 1 of the "
            "second");
  EXPECT_EQ(difference(base, base + "G0 X9\n"),
            "motion after the end of the first, line 5");
  EXPECT_FALSE(measure_program_deviation(read(base), read(base), 0));
}

TEST(program_deviation, stops_at_its_limit) {
  EXPECT_GT(measured("G0 X0\nG1 X9 F1\n", "G0 X50\nG1 X9 F1\n", 0.1).least,
            0.1);
}

TEST(program_deviation, is_what_the_oracle_finds) {
  std::mt19937 random(3);
  const auto text = [&](double noise) {
    std::string out = "G0 X0 Y0 Z0\nG1 F100 ";
    std::mt19937 shape(7);
    std::uniform_real_distribution<double> by(-noise, noise);
    for (int i = 1; i <= 60; ++i) {
      const double angle = static_cast<double>(shape() % 1000) / 500;
      out += "X" + std::to_string(0.7 * i * std::cos(angle) + by(random)) +
             " Y" + std::to_string(0.7 * i * std::sin(angle) + by(random)) +
             " Z" + std::to_string(by(random)) + "\n";
    }
    return out;
  };
  for (int i = 0; i < 20; ++i) {
    const std::string a = text(0);
    const std::string b = text(0.01 * (i + 1));
    const ProgramDeviation found = measured(a, b);
    const auto near = [&](double bound) {
      return oracle::compare(read(a), read(b), bound).empty();
    };
    EXPECT_TRUE(near(found.distance * 1.001)) << i;
    EXPECT_FALSE(near(found.least * 0.999)) << i;
  }
}

}  // namespace
}  // namespace unstep
