#include "unstep/step_stream.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <string>

namespace unstep {
namespace {

constexpr StepFormat kFormats[] = {StepFormat::binary, StepFormat::csv,
                                   StepFormat::vcd};

Program program_of(const std::string& text) {
  const Result<Program> program = read_gcode(text, {});
  EXPECT_TRUE(program) << program.error().message;
  return program ? *program : Program();
}

StepStream steps_of(const std::string& text, StepMakeOptions options = {}) {
  const Result<StepStream> stream = make_steps(program_of(text), options);
  EXPECT_TRUE(stream) << stream.error().message;
  return stream ? *stream : StepStream();
}

/// Lines and arcs of every size, rapids among them.
std::string random_program(unsigned seed, bool arcs, int axes) {
  std::mt19937 random(seed);
  const auto coordinate = [&random](int most) {
    const int whole =
        static_cast<int>(random() % static_cast<unsigned>(2 * most)) - most;
    return std::to_string(whole / 100.0);
  };
  std::string text = "G21 G90\nG0 X1 Y2 Z0\n";
  for (int i = 0; i < 40; ++i) {
    const int most = i % 3 == 0 ? 30 : 3000;
    text += random() % 5 == 0 ? "G0" : "G1";
    text += " X" + coordinate(most) + " Y" + coordinate(most);
    if (axes == 3) text += " Z" + coordinate(most);
    text += " F900\n";
    if (!arcs || random() % 2 == 0) continue;
    text += random() % 2 == 0 ? "G2" : "G3";
    text += " I" + coordinate(900) + " J" + coordinate(900) + "\n";
  }
  return text;
}

std::uint64_t count_of(const StepStream& stream) {
  std::uint64_t count = 0;
  for (const StepRun& run : stream.runs) count += run.words.size();
  return count;
}

void expect_same_again(const StepStream& stream, StepMakeOptions how) {
  StepReverseOptions options;
  options.method = how.method;
  const Result<Program> back = reverse_steps(stream, options);
  ASSERT_TRUE(back) << back.error().message;
  const Result<StepStream> again = make_steps(*back, how);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(*again, stream);
}

TEST(steps, are_the_unit_steps_of_a_line) {
  const StepStream stream = steps_of("G0 X0 Y0\nG1 X0.03 Y0.01 F600\n");
  ASSERT_EQ(stream.runs.size(), 1U);
  EXPECT_FALSE(stream.runs[0].rapid);
  EXPECT_EQ(stream.runs[0].words, (std::vector<StepWord>{1, 5, 1}));
  EXPECT_EQ(stream.head.axes, 2);
  const StepStream back = steps_of("G0 X0.02 Y0\nG0 X0 Y-0.01\n");
  ASSERT_EQ(back.runs.size(), 1U);
  EXPECT_TRUE(back.runs[0].rapid);
}

TEST(steps, of_three_axes_move_together) {
  StepMakeOptions options;
  options.axes = 3;
  const StepStream stream =
      steps_of("G0 X0 Y0 Z0\nG1 X0.04 Y-0.02 Z0.01 F600\n", options);
  std::array<int, 3> sum{};
  for (const StepWord word : stream.runs[0].words) {
    ASSERT_TRUE(is_step_word(word, 3));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sum[axis] += step_of(word, axis);
    }
  }
  EXPECT_EQ(stream.runs[0].words.size(), 4U);
  EXPECT_EQ(sum, (std::array<int, 3>{4, -2, 1}));
}

TEST(steps, come_back_from_every_format) {
  for (const int axes : {2, 3}) {
    for (const bool timed : {false, true}) {
      StepMakeOptions options;
      options.axes = axes;
      options.timed = timed;
      const StepStream stream =
          steps_of(random_program(3, true, axes), options);
      for (const StepFormat format : kFormats) {
        const Result<std::string> bytes = write_steps(stream, format);
        ASSERT_TRUE(bytes) << bytes.error().message;
        EXPECT_EQ(recognise_steps(*bytes), format);
        const Result<StepStream> back = read_steps(*bytes, format, {});
        ASSERT_TRUE(back) << back.error().message;
        EXPECT_EQ(back->head, stream.head);
        EXPECT_TRUE(*back == stream) << static_cast<int>(format) << timed;
      }
    }
  }
}

TEST(steps, have_the_same_bytes_however_many_motions_make_them) {
  std::string whole = "G0 X0 Y0\nG1 X3000 Y0 F600\nG0 X3001\n";
  std::string pieces = "G0 X0 Y0\n";
  for (int i = 1; i <= 3000; ++i) {
    pieces += "G1 X" + std::to_string(i) + " F600\n";
  }
  pieces += "G0 X3001\n";
  const auto bytes_of = [](const std::string& text) {
    std::string bytes;
    Result<StepWriter> writer = StepWriter::create(
        StepFormat::binary, step_head({}), [&bytes](std::string_view more) {
          bytes += more;
          return Status();
        });
    EXPECT_TRUE(make_steps(program_of(text), {}, [&](const StepRun& run) {
      return writer->add(run);
    }));
    EXPECT_TRUE(writer->finish());
    return bytes;
  };
  EXPECT_EQ(bytes_of(whole), bytes_of(pieces));
}

TEST(steps, come_back_from_raw_bytes) {
  StepStream stream = steps_of("G1 X0.03 Y0.01 F600\n");
  const std::string bytes = *write_steps(stream, StepFormat::raw);
  EXPECT_EQ(bytes, "\x01\x05\x01");
  EXPECT_EQ(*read_steps(bytes, StepFormat::raw, {}), stream);
  EXPECT_FALSE(read_steps("\x01\x02", StepFormat::raw, {}));
}

TEST(reversed_steps, make_the_same_steps_again) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    for (const Method method :
         {Method::evaluation8, Method::evaluation, Method::device}) {
      StepMakeOptions how;
      how.method = method;
      expect_same_again(steps_of(random_program(seed, true, 2), how), how);
    }
    StepMakeOptions how;
    how.axes = 3;
    expect_same_again(steps_of(random_program(seed, true, 3), how), how);
  }
}

TEST(reversed_steps, of_noise_make_the_same_steps_again) {
  std::mt19937 random(5);
  StepStream stream;
  StepRun& run = stream.runs.emplace_back();
  constexpr StepWord kAny[] = {1, 3, 4, 12, 5, 7, 13, 15};
  for (int i = 0; i < 5000; ++i) run.words.push_back(kAny[random() % 8]);
  stream.head.origin = {700, -900, 0};
  StepMakeOptions how;
  how.origin = stream.head.origin;
  expect_same_again(stream, how);
  how.axes = stream.head.axes = 3;
  for (StepWord& word : run.words) {
    word = static_cast<StepWord>(word | (random() % 2 == 0 ? 16U : 0U));
  }
  expect_same_again(stream, how);
}

TEST(reversed_steps, of_polygons_and_circles_are_these) {
  const std::string text =
      "G21 G90 G17 G94\n"
      "G0 X0 Y0\n"
      "G1 X10.37 Y3.01 F1000\nG1 X4.2 Y12.9 F1000\nG1 X0 Y0 F1000\n"
      "G0 X20 Y20\n"
      "G2 X20 Y20 I5.01 J2.5 F1000\n"
      "G0 X-3 Y-8\n"
      "G3 X2 Y-3 I0 J5 F1000\n"
      "G1 X2 Y10 F1000\n";
  const Result<Program> back = reverse_steps(steps_of(text), {});
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->text, text);
}

/// A path of lines and of arcs of every radius, flat ones among them.
std::string mixed_path(unsigned seed, int count) {
  std::mt19937 random(seed);
  const auto share = [&random] {
    return static_cast<double>(random() % 2000) / 1000 - 1;
  };
  std::string text = "G21 G90 G91.1\nG0 X0 Y0\nG91\n";
  for (int i = 0; i < count; ++i) {
    const double x = std::round(1500 * share());
    const double y = std::round(1500 * share());
    const auto word = [](const char* name, double steps) {
      return name + std::to_string(std::round(steps) / 100);
    };
    if (x == 0 && y == 0) continue;
    if (i % 3 == 0) {
      text += "G1" + word(" X", x) + word(" Y", y) + " F900\n";
      continue;
    }
    // The centre beside the middle of the chord, 0.6 to 20 chords away.
    const double away = std::exp(2 + 1.5 * share()) - 1;
    text += (random() % 2 == 0 ? "G2" : "G3") + word(" X", x) + word(" Y", y) +
            word(" I", x / 2 - away * y) + word(" J", y / 2 + away * x) +
            " F900\n";
  }
  return text;
}

TEST(reversed_steps, of_three_axes_have_circles_where_z_rests) {
  const std::string text =
      "G21 G90 G17 G94\n"
      "G0 X0 Y0 Z5\n"
      "G1 X0 Y0 Z-1 F1000\nG3 X0 Y0 Z-1 I5.01 J2.5 F1000\n"
      "G1 X10.37 Y3.01 Z-1 F1000\nG1 X12 Y3.01 Z-2 F1000\n"
      "G2 X17 Y8.01 Z-2 I5 J0 F1000\n"
      "G0 X17 Y8.01 Z5\n";
  StepMakeOptions how;
  how.axes = 3;
  how.origin = {0, 0, 500};
  const StepStream stream = steps_of(text, how);
  const Result<Program> back = reverse_steps(stream, {});
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->text, text);
}

TEST(reversed_steps, of_arcs_in_a_long_path_are_not_many_more) {
  const StepStream stream = steps_of(mixed_path(4, 60));
  const Result<Program> back = reverse_steps(stream, {});
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(*make_steps(*back, StepMakeOptions{}), stream);
  std::size_t motions = 0;
  for (const ProgramItem& item : back->items) motions += item.is_motion();
  EXPECT_LE(motions, 80U);
}

TEST(steps, of_an_arc_whose_rounded_ends_are_off_its_circle_are_an_arc) {
  // 57 mm away: rounding leaves the end more than a step off the circle.
  const StepStream stream = steps_of(
      "G0 X5.716 Y5.3334\n"
      "G2 X14.004 Y16.506 I49.7281 J-28.2288 F900\n");
  const Result<Program> back = reverse_steps(stream, {});
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->items.back().kind, ProgramItem::Kind::clockwise);
  EXPECT_EQ(back->text.find("G1 "), std::string::npos) << back->text;
}

TEST(steps, of_an_arc_whose_ends_are_one_on_the_grid_are_all_of_it_or_none) {
  EXPECT_GT(count_of(steps_of("G0 X0 Y0\nG2 Y-0.001 I1 F9\n")), 500U);
  EXPECT_EQ(count_of(steps_of("G0 X0 Y0\nG3 Y-0.001 I1 F9\n")), 0U);
}

TEST(timed_steps, keep_the_feed_without_a_limit) {
  StepMakeOptions options;
  options.timed = true;
  options.timing.acceleration = 0;
  const StepStream stream = steps_of("G0 X0 Y0\nG1 X10 F600\n", options);
  // 10 mm/s at 0.01 mm a step.
  for (const std::uint32_t wait : stream.runs[0].waits) {
    EXPECT_NEAR(wait, 1000, 1);
  }
}

TEST(timed_steps, speed_up_and_brake_as_the_acceleration_allows) {
  StepMakeOptions options;
  options.timed = true;
  options.timing.acceleration = 100;
  const StepStream stream = steps_of("G0 X0 Y0\nG1 X10 F600\n", options);
  const auto& waits = stream.runs[0].waits;
  const auto ticks =
      std::accumulate(waits.begin(), waits.end(), std::uint64_t{0});
  // 0.1 s to 10 mm/s and 0.1 s back take 1 mm, the other 9 mm 0.9 s.
  EXPECT_NEAR(static_cast<double>(ticks), 1.1e6, 5);
  EXPECT_NEAR(waits[500], 1000, 1);
  EXPECT_GT(waits[0], 10'000U);
  // Never more than the acceleration, by the speeds between three steps.
  for (std::size_t i = 2; i < waits.size(); ++i) {
    const double v0 = 1e4 / waits[i - 1];
    const double v1 = 1e4 / waits[i];
    const double seconds = (waits[i - 1] + waits[i]) / 2e6;
    EXPECT_LT(std::abs(v1 - v0) / seconds, 105 + 3e4 / waits[i]) << i;
  }
}

TEST(timed_steps, come_within_half_a_tick_of_where_the_speed_says) {
  StepMakeOptions options;
  options.timed = true;
  options.timing.acceleration = 100;
  const StepStream stream =
      steps_of("G0 X0 Y0\nG1 X3 F600\nG1 X10 F1200\n", options);
  // 10 mm/s after 0.5 mm and 0.1 s, 3 mm after 0.35 s, 20 mm/s after 1.5 mm
  // and 0.1 s more, until 2 mm before the end.
  const auto seconds = [](double way) {
    if (way <= 0.5) return std::sqrt(way / 50);
    if (way <= 3) return 0.1 + (way - 0.5) / 10;
    if (way <= 4.5) return 0.35 + (std::sqrt(100 + 200 * (way - 3)) - 10) / 100;
    if (way <= 8) return 0.45 + (way - 4.5) / 20;
    return 0.625 + 0.2 - std::sqrt((10 - way) / 50);
  };
  std::uint64_t ticks = 0;
  for (std::size_t i = 0; i < stream.runs[0].waits.size(); ++i) {
    ticks += stream.runs[0].waits[i];
    const double way = static_cast<double>(i + 1) / 100;
    EXPECT_NEAR(static_cast<double>(ticks), 1e6 * seconds(way), 0.501) << way;
  }
  EXPECT_EQ(stream.runs[0].waits.size(), 1000U);
}

TEST(timed_steps, of_a_slow_clock_come_one_a_tick) {
  StepMakeOptions options;
  options.timed = true;
  options.timing.clock = 100;
  const StepStream stream =
      steps_of("G0 X0 Y0\nG1 X10 F600\nG1 X10.05 F6\n", options);
  const auto& waits = stream.runs[0].waits;
  // 1 ms apart is too near.
  for (std::size_t i = 20; i < 980; ++i) EXPECT_EQ(waits[i], 1U) << i;
  EXPECT_EQ(waits.size(), 1005U);
}

TEST(timed_steps, may_be_most_of_2_to_the_32_ticks_apart) {
  StepMakeOptions options;
  options.timed = true;
  options.timing.acceleration = 0;
  options.timing.clock = 4'000'000'000;
  std::string text = "G0 X0 Y0\n";
  for (int i = 0; i < 20; ++i) {
    text += "G91 G1 X0.05 F" + std::string(i % 2 == 0 ? "0.57" : "6000") + "\n";
  }
  const StepStream stream = steps_of(text, options);
  EXPECT_GT(stream.runs[0].waits[1], 4'200'000'000U);
  EXPECT_EQ(stream.runs[0].waits[7], 400'000U);
  EXPECT_EQ(*read_steps(*write_steps(stream, StepFormat::binary),
                        StepFormat::binary, {}),
            stream);
  options.timing.feed = 0.5;
  EXPECT_FALSE(make_steps(program_of("G0 X0 Y0\nG1 X1\n"), options));
}

TEST(timed_steps, look_ahead_over_short_moves) {
  StepMakeOptions options;
  options.timed = true;
  const auto time = [&options](const std::string& text) {
    std::uint64_t ticks = 0;
    for (const StepRun& run : steps_of(text, options).runs) {
      ticks = std::accumulate(run.waits.begin(), run.waits.end(), ticks);
    }
    return static_cast<double>(ticks);
  };
  std::string pieces = "G0 X0 Y0\n";
  std::string zigzag = "G0 X0 Y0\n";
  for (int i = 1; i <= 100; ++i) {
    pieces += "G1 X" + std::to_string(i * 0.1) + " F3000\n";
    zigzag += "G1 X" + std::to_string(i % 2 * 0.1) + " F3000\n";
  }
  const double whole = time("G0 X0 Y0\nG1 X10 F3000\n");
  EXPECT_NEAR(time(pieces), whole, 200);
  EXPECT_GT(time(zigzag), 4 * whole);
}

TEST(foreign_dumps, are_read_by_the_names_of_wires) {
  const std::string text =
      "$date today $end $timescale 1 us $end\n"
      "$scope module top $end\n"
      "$var wire 1 ! X_STEP $end\n$var wire 1 \" X_DIR $end\n"
      "$var wire 1 # y_step $end\n$var reg 1 $ y_dir $end\n"
      "$var wire 8 % bus [7:0] $end\n"
      "$upscope $end $enddefinitions $end\n"
      "#0 $dumpvars 0! 0\" 0# x$ b0 % $end\n"
      "#10 1!\n#12 0!\n#20 1\" 1!\n#21 0! 1$\n#30 1! 1#\n#31 0! 0#\n";
  const Result<StepStream> stream = read_steps(text, StepFormat::vcd, {});
  ASSERT_TRUE(stream) << stream.error().message;
  ASSERT_EQ(stream->runs.size(), 1U);
  EXPECT_EQ(stream->head.clock, 1'000'000U);
  EXPECT_EQ(stream->runs[0].words, (std::vector<StepWord>{1, 3, 15}));
  EXPECT_EQ(stream->runs[0].waits, (std::vector<std::uint32_t>{10, 10, 10}));
}

TEST(damaged_steps, are_refused) {
  StepMakeOptions options;
  options.timed = true;
  const StepStream stream =
      steps_of("G0 X0.1 Y0\nG1 X0.25 Y0.1 F600\nG0 X0 Y0\n", options);
  std::string bytes = *write_steps(stream, StepFormat::binary);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(read_steps(bytes.substr(0, size), StepFormat::binary, {}));
  }
  EXPECT_FALSE(read_steps(bytes + '\0', StepFormat::binary, {}));
  for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ 1 << bit % 8);
    EXPECT_FALSE(read_steps(bytes, StepFormat::binary, {})) << bit;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ 1 << bit % 8);
  }
}

TEST(damaged_steps, as_text_are_sound) {
  StepMakeOptions options;
  options.timed = true;
  const StepStream stream = steps_of("G1 X0.05 Y0.02 F600\n", options);
  for (const StepFormat format : {StepFormat::csv, StepFormat::vcd}) {
    std::string text = *write_steps(stream, format);
    for (std::size_t size = 0; size < text.size(); ++size) {
      const auto cut = read_steps(text.substr(0, size), format, {});
      if (cut) {
        EXPECT_LE(count_of(*cut), count_of(stream));
      }
    }
    for (std::size_t bit = 0; bit < text.size() * 8; ++bit) {
      text[bit / 8] = static_cast<char>(text[bit / 8] ^ 1 << bit % 8);
      const auto read = read_steps(text, format, {});
      if (read) {
        EXPECT_TRUE(write_steps(*read, StepFormat::binary));
      }
      text[bit / 8] = static_cast<char>(text[bit / 8] ^ 1 << bit % 8);
    }
  }
}

TEST(device_profile, makes_the_same_steps) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Program program = program_of(random_program(seed, true, 2));
    const Result<StepStream> steps = make_steps(program, StepMakeOptions{});
    const Result<std::string> bytes = write_device_profile(program, {});
    ASSERT_TRUE(steps && bytes);
    const Result<StepStream> drawn = read_device_profile(*bytes, {});
    ASSERT_TRUE(drawn) << drawn.error().message;
    EXPECT_TRUE(*drawn == *steps) << seed;
  }
}

TEST(device_profile, draws_arcs_of_every_octant) {
  std::string text = "G0 X0 Y0\n";
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) {
      if (i == 0 && j == 0) continue;
      for (const char* way : {"G2", "G3"}) {
        const auto part = [](int steps) {
          return std::to_string(steps * 7 / 100.0);
        };
        const std::string centre = " I" + part(i) + " J" + part(j) + " F9\n";
        text += way + centre;
        // A quarter, half and three quarters of the circle, and back.
        text += "G91\n";
        for (const auto& [x, y] :
             {std::pair{i - j, j + i}, std::pair{2 * i, 2 * j},
              std::pair{i + j, j - i}}) {
          text += std::string(way) + " X" + part(x) + " Y" + part(y) + centre;
        }
        text += "G90\nG0 X0 Y0\n";
      }
    }
  }
  const Program program = program_of(text);
  const Result<StepStream> drawn =
      read_device_profile(*write_device_profile(program, {}), {});
  ASSERT_TRUE(drawn) << drawn.error().message;
  EXPECT_EQ(*drawn, *make_steps(program, StepMakeOptions{}));
}

TEST(device_profile, cuts_what_its_numbers_do_not_hold) {
  const Program program = program_of(
      "G0 X0 Y0\nG1 X400 Y33.33 F9\nG2 X402 Y33.33 I1 J-500\n"
      "G1 X402 Y-327.68\n");
  const Result<StepStream> drawn =
      read_device_profile(*write_device_profile(program, {}), {});
  ASSERT_TRUE(drawn) << drawn.error().message;
  EXPECT_TRUE(*drawn == *make_steps(program, StepMakeOptions{}));
}

TEST(device_profile, is_refused_when_damaged) {
  std::string bytes = *write_device_profile(
      program_of("G0 X1 Y2\nG1 X3 Y2 F9\nG2 X4 Y3 I1\nG2 I1 J0.5\n"), {});
  StepReadOptions options;
  options.max_steps = 100'000;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(read_device_profile(bytes.substr(0, size), options));
  }
  EXPECT_FALSE(read_device_profile(bytes + '\0', options));
  for (std::size_t bit = 0; bit < bytes.size() * 8; ++bit) {
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ 1 << bit % 8);
    EXPECT_FALSE(read_device_profile(bytes, options)) << bit;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ 1 << bit % 8);
  }
}

TEST(steps, are_limited) {
  StepMakeOptions options;
  options.max_steps = 100;
  const auto made = make_steps(program_of("G0 X0 Y0\nG1 X10 F600\n"), options);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::limit_exceeded);
  StepReadOptions read;
  read.max_steps = 2;
  EXPECT_FALSE(read_steps("x,y\n1,0\n1,0\n1,0\n", StepFormat::csv, read));
  options = {};
  options.method = Method::circular;
  EXPECT_FALSE(make_steps(program_of("G1 X1\n"), options));
  EXPECT_FALSE(make_steps(program_of("M123\nG1 X1\n"), {}));
  options = {};
  options.step = 1;
  EXPECT_FALSE(make_steps(program_of("G0 X200 Y0\n"), options));
}

}  // namespace
}  // namespace unstep
