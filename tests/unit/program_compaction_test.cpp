#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <string>

#include "unit/program_oracle.h"
#include "unstep/program.h"

namespace unstep {
namespace {

using Kind = ProgramItem::Kind;

std::string word(char letter, double value, int decimals) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%c%.*f", letter, decimals, value);
  return text.data();
}

Program read(const std::string& text) {
  Result<Program> program = read_gcode(text, {});
  EXPECT_TRUE(program) << (program ? "" : program.error().message);
  return program ? *program : Program{};
}

/// Shortened, and checked by the oracle, as it is and as it is read again
/// from what is written of it.
Program shorten(std::string text, const CompactOptions& options,
                CompactReport* report = nullptr) {
  if (text.find("M2\n") == std::string::npos) text += "M2\n";
  const Program before = read(text);
  const Result<Program> after = compact(before, options, report);
  EXPECT_TRUE(after);
  if (!after) return {};
  EXPECT_EQ(oracle::compare(before, *after, options.tolerance_mm), "") << text;
  GcodeWriteOptions write;
  if (options.rules.by_radius) write.arcs = GcodeWriteOptions::ArcForm::radius;
  const Result<std::string> out = write_gcode(*after, write);
  EXPECT_TRUE(out);
  const Program again = read(*out);
  EXPECT_EQ(oracle::compare(before, again, options.tolerance_mm), "") << *out;
  return *after;
}

std::size_t motions(const Program& program) {
  std::size_t count = 0;
  for (const ProgramItem& item : program.items) {
    count += item.is_motion() && item.kind != Kind::rapid;
  }
  return count;
}

std::size_t arcs(const Program& program) {
  std::size_t count = 0;
  for (const ProgramItem& item : program.items) count += item.is_arc();
  return count;
}

constexpr const char* kHead = "G21 G90 G17\nG0 X0 Y0 Z0\nF600\n";

/// A circle in tiny lines, from angle to angle.
std::string circle(double radius, double from, double to, int count,
                   int decimals) {
  std::string text;
  for (int i = 0; i <= count; ++i) {
    const double a = from + (to - from) * i / count;
    text += "G1 " + word('X', radius * std::cos(a), decimals) + " " +
            word('Y', radius * std::sin(a), decimals) + "\n";
  }
  return text;
}

TEST(compaction, a_line_in_pieces_becomes_one_line) {
  std::string text = kHead;
  for (int i = 1; i <= 100; ++i) {
    text += "G1 " + word('X', i * 0.3, 3) + " " + word('Y', i * 0.1, 3) +
            word('Z', -i * 0.05, 3) + "\n";
  }
  const Program after = shorten(text, {.tolerance_mm = 0.002});
  EXPECT_EQ(motions(after), 1U);
  EXPECT_EQ(after.items[3].end[2], -5 * kProgramUnitsPerMm);
}

TEST(compaction, a_circle_in_pieces_becomes_an_arc) {
  for (const double turn : {1.0, -1.0}) {
    for (const double sweep : {0.5, 2.0, 4.0, 6.2}) {
      const std::string text =
          kHead + circle(20, 1, 1 + turn * sweep, 500, 4) + "G0 Z5\n";
      const Program after = shorten(text, {.tolerance_mm = 0.005});
      EXPECT_EQ(motions(after), 2U) << sweep;
      EXPECT_EQ(arcs(after), 1U) << sweep;
      const Kind kind = turn > 0 ? Kind::counter : Kind::clockwise;
      EXPECT_TRUE(after.items[4].kind == kind) << sweep;
    }
  }
}

TEST(compaction, arcs_keep_the_rules_of_the_control) {
  const std::string text = kHead + circle(20, 0, 6.2, 500, 4);
  CompactOptions options{.tolerance_mm = 0.005};
  options.rules.max_sweep_degrees = 120;
  EXPECT_EQ(arcs(shorten(text, options)), 3U);
  options.rules.max_sweep_degrees = 360;
  options.rules.quadrants = true;
  EXPECT_EQ(arcs(shorten(text, options)), 4U);
  options.rules.quadrants = false;
  options.rules.by_radius = true;
  const Program by_radius = shorten(text, options);
  // Of 340 degrees, and the rest.
  EXPECT_EQ(arcs(by_radius), 2U);
  EXPECT_LT(by_radius.items[4].radius, 0);
  EXPECT_GT(by_radius.items[5].radius, 0);
  options.arcs = false;
  EXPECT_EQ(arcs(shorten(text, options)), 0U);
}

TEST(compaction, arcs_come_in_other_planes_too) {
  std::string text = "G21 G90 G19\nG0 X1 Y10 Z0\nF600\n";
  for (int i = 1; i <= 200; ++i) {
    text += "G1 " + word('Y', 10 * std::cos(i * 0.01), 4) +
            word('Z', 10 * std::sin(i * 0.01), 4) + "\n";
  }
  const Program after = shorten(text, {.tolerance_mm = 0.005});
  EXPECT_EQ(motions(after), 1U);
  EXPECT_EQ(arcs(after), 1U);
}

TEST(compaction, nothing_is_merged_across_what_stands_between) {
  for (const char* between :
       {"G4 P1", "M5", "T1 M6", "F300", "S100", "G61", "G64 P0.01", "(note)",
        "G0 X6", "M123", "G93\nG94", "G41 D1\nG40", "G92 X6", "/X7", "G18",
        "G91\nG90", "G20\nG21", "G2 X6 I0.5 P2", "G81 Z-1 R1\nG80\nG1"}) {
    const std::string text = std::string(kHead) +
                             "G1 X1 Y0 Z0\nX2\nX3\nX6 Y0 Z0\n" + between +
                             "\nG1 X7 Y0 Z0\nX8\nX9\n";
    const Result<Program> after = compact(read(text), {.tolerance_mm = 0.01});
    ASSERT_TRUE(after);
    const Result<std::string> out = write_gcode(*after, {});
    EXPECT_NE(out->find("X6"), std::string::npos) << between << "\n" << *out;
    EXPECT_EQ(out->find("X2"), std::string::npos) << between << "\n" << *out;
  }
}

TEST(compaction, retraced_lines_keep_their_turning_points) {
  std::string text = kHead;
  for (int i = 1; i <= 20; ++i) text += "G1 " + word('X', i, 3) + "\n";
  for (int i = 19; i >= 5; --i) text += "G1 " + word('X', i, 3) + "\n";
  for (int i = 6; i <= 12; ++i) text += "G1 " + word('X', i, 3) + "\n";
  EXPECT_EQ(motions(shorten(text, {.tolerance_mm = 0.1})), 3U);
  // Below the tolerance a step back is no turn.
  text = kHead;
  for (int i = 1; i <= 50; ++i) {
    text += "G1 " + word('X', i * 0.1 - (i % 2) * 0.15, 3) + "\n";
  }
  EXPECT_EQ(motions(shorten(text, {.tolerance_mm = 0.2})), 1U);
}

TEST(compaction, motions_from_an_unknown_position_stay) {
  // Y is not known before line 3.
  const Program after =
      *compact(read("G1 X1 F9\nX2\nX3 Y1\nX4\nX5\n"), {.tolerance_mm = 10});
  EXPECT_EQ(motions(after), 4U);
}

TEST(compaction, text_that_builds_on_the_position_finds_it_exact) {
  std::string text = kHead;
  for (int i = 1; i <= 9; ++i) {
    text +=
        "G1 " + word('X', i * 0.12345, 5) + word('Y', i * 0.33333, 5) + "\n";
  }
  const Program rounded = *compact(read(text), {.tolerance_mm = 0.05});
  EXPECT_NE(rounded.items.back().end[0], 11'110'500);
  for (const char* next : {"G91\nX1", "G92 X0", "M123", "G53 G0 X0"}) {
    const Program exact =
        *compact(read(text + next + "\n"), {.tolerance_mm = 0.05});
    EXPECT_EQ(exact.items[3].end[0], 11'110'500) << next;
  }
}

TEST(compaction, extrusion_per_length_stays_within_its_bound) {
  std::string text = "G21 G90 M82\nG92 E0\nG0 X0 Y0 Z0\nF600\n";
  double e = 0;
  for (int i = 1; i <= 60; ++i) {
    e += i <= 30 ? 0.02 : 0.03;
    text += "G1 " + word('X', i, 3) + " Y0 " + word('E', e, 5) + "\n";
  }
  text += "G1 E0.1\n";  // drawn back
  const Program after = shorten(text, {.tolerance_mm = 0.01});
  EXPECT_EQ(motions(after), 3U);
  EXPECT_EQ(after.position(after.items.back())[9], 1'000'000);
}

TEST(compaction, a_tolerance_below_the_rounding_changes_no_vertex) {
  const std::string text = kHead + circle(20, 0, 6, 60, 3);
  const Program before = read(text);
  const Program after = shorten(text, {.tolerance_mm = 0.0001});
  EXPECT_EQ(motions(after), motions(before));
}

TEST(compaction, options_are_checked) {
  const Program program = read(std::string(kHead) + "G1 X0.1234\n");
  EXPECT_FALSE(compact(program, {.tolerance_mm = 0}));
  EXPECT_FALSE(compact(program, {.tolerance_mm = std::nan("")}));
  CompactOptions coarse{.tolerance_mm = 0.005};
  coarse.decimals = 1;
  EXPECT_FALSE(compact(program, coarse));
}

/// Wavy, noisy, cornered, retracing, repeating paths of all sizes.
std::string random_program(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const int decimals = 1 + static_cast<int>(random() % 5);
  const bool inches = random() % 4 == 0;
  const bool incremental = random() % 4 == 0;
  std::string text = std::string(inches ? "G20" : "G21") + " G90 G17\n";
  text += "G0 X0 Y0 Z0\nG1 X0 Y0 Z0 F100\n";
  if (incremental) text += "G91\n";
  double x = 0;
  double y = 0;
  double z = 0;
  double heading = 0;
  double turn = 0;
  double climb = 0;
  double length = 0.1;
  for (int i = 0; i < 300; ++i) {
    if (random() % 25 == 0) {
      turn = random() % 3 == 0 ? 0 : unit(random) * 0.2;
      climb = random() % 3 == 0 ? unit(random) : 0;
      length = std::pow(10, unit(random));
      if (random() % 3 == 0) heading += unit(random) * 4;
    }
    heading += turn;
    const double noise = random() % 2 == 0 ? 0 : 0.002;
    const double dx = length * std::cos(heading) + noise * unit(random);
    const double dy = length * std::sin(heading) + noise * unit(random);
    x += dx;
    y += dy;
    z += climb * length;
    text += word('X', incremental ? dx : x, decimals) + " " +
            word('Y', incremental ? dy : y, decimals);
    if (climb != 0) {
      text += " " + word('Z', incremental ? climb * length : z, decimals);
    }
    text += "\n";
    if (random() % 60 == 0) text += "G0 Z1\nG1\n";
    if (random() % 60 == 0) text += "M8\n";
  }
  return text;
}

TEST(compaction, random_programs_stay_within_every_tolerance) {
  std::mt19937 random(7);
  for (int i = 0; i < 60; ++i) {
    const std::string text = random_program(random);
    CompactOptions options;
    options.tolerance_mm = std::pow(10, -3.0 + static_cast<double>(i % 7) / 2);
    options.rules.by_radius = i % 3 == 1;
    options.rules.quadrants = i % 5 == 2;
    CompactReport report;
    shorten(text, options, &report);
    if (!options.rules.quadrants) {
      EXPECT_LE(report.lines_after, report.lines_before);
    }
    if (HasFailure()) {
      FAIL() << "program " << i << ", tolerance " << options.tolerance_mm;
    }
  }
}

TEST(compaction, the_sample_of_tiny_segments_shrinks_as_promised) {
  std::ifstream file(UNSTEP_SOURCE_DIR "/tests/programs/tiny.ngc");
  const std::string text((std::istreambuf_iterator<char>(file)),
                         std::istreambuf_iterator<char>());
  CompactReport report;
  shorten(text, {.tolerance_mm = 0.005}, &report);
  EXPECT_LE(report.lines_after * 10, report.lines_before * 3);
}

TEST(compaction_oracle, finds_what_is_too_far) {
  const oracle::Path3 line{{0, 0, 0}, {10, 0, 0}};
  const oracle::Path3 bump{{0, 0, 0}, {5, 1, 0}, {10, 0, 0}};
  EXPECT_TRUE(oracle::frechet_within(line, bump, 1.001));
  EXPECT_FALSE(oracle::frechet_within(line, bump, 0.999));
  // There, back, and there again: the Hausdorff distance would be 0.
  const oracle::Path3 zigzag{{0, 0, 0}, {8, 0, 0}, {2, 0, 0}, {10, 0, 0}};
  EXPECT_TRUE(oracle::frechet_within(line, zigzag, 3.001));
  EXPECT_FALSE(oracle::frechet_within(line, zigzag, 2.999));
}

TEST(compaction, makes_one_arc_of_arcs_on_one_circle) {
  CompactOptions options;
  const std::string quarters =
      "G0 X10 Y0 Z0\nG1 F600\nG3 X0 Y10 I-10\nX-10 Y0 J-10\nX0 Y-10 I10\n";
  const Program most = shorten(quarters, options);
  EXPECT_EQ(arcs(most), 1U);
  const Program whole = shorten(quarters + "X10 Y0 J10\n", options);
  EXPECT_EQ(arcs(whole), 1U);
  EXPECT_EQ(arcs(shorten(quarters + "X10 Y0 J10\nX0 Y10 I-10\n", options)), 2U);
}

TEST(compaction, keeps_arcs_apart_that_are_not_one) {
  CompactOptions options;
  const std::string begin = "G0 X10 Y0 Z0\nG1 F600\nG3 X0 Y10 I-10\n";
  for (const char* next :
       {"X-10 Y0 J-10 F300\n", "(here)\nX-10 Y0 J-10\n", "G2 X10 Y0 J-10\n",
        "X-10 Y0 J-10 Z1\n", "X-9.9 Y0.1 J-9.9\n", "X-20 Y-10 J-20\n"}) {
    EXPECT_EQ(arcs(shorten(begin + next, options)), 2U) << next;
  }
}

TEST(compaction, merges_arcs_no_farther_than_the_tolerance) {
  // Radii that grow by 0.0006 mm a quarter: one arc would be 0.0024 mm off.
  const std::string spiral =
      "G0 X10 Y0 Z0\nG1 F600\nG3 X0 Y10.0006 I-10\nX-10.0012 Y0 J-10.0006\n"
      "X0 Y-10.0018 I10.0012\nX10.0024 Y0 J10.0018\n";
  CompactOptions options;
  options.tolerance_mm = 0.001;
  EXPECT_GT(arcs(shorten(spiral, options)), 1U);
  options.tolerance_mm = 0.02;
  EXPECT_LT(arcs(shorten(spiral, options)), 4U);
}

}  // namespace
}  // namespace unstep
