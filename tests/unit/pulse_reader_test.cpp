#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <vector>

#include "pulse_testing.h"
#include "unstep/formats.h"
#include "unstep/trace.h"

namespace unstep {
namespace {

using test::make_session;
using Strings = std::vector<std::string>;

/// A and B of the four phases of a cycle, upwards.
constexpr std::array<std::pair<bool, bool>, 4> kPhases{
    {{false, false}, {true, false}, {true, true}, {false, true}}};

std::pair<bool, bool> phase(int position) {
  return kPhases[static_cast<std::size_t>(position & 3)];
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

Result<VectorPage> try_read(const std::string& text, PulseFormat format,
                            const Strings& channels = {}, int counts = 4) {
  PulseReadOptions options;
  options.channels = channels;
  options.counts = counts;
  return read_pulses(bytes_of(text), format, options);
}

/// The Freeman codes as digits, or the error.
std::string codes(const Result<VectorPage>& page) {
  if (!page) return page.error().message;
  std::string text;
  for (const Step step : page->drawing.chains.at(0).steps) {
    text += static_cast<char>('0' + step);
  }
  return text;
}

std::string codes(const std::string& text, PulseFormat format,
                  const Strings& channels = {}, int counts = 4) {
  return codes(try_read(text, format, channels, counts));
}

bool has_note(const VectorPage& page, const std::string& part) {
  for (const std::string& note : page.notes) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

TEST(QuadratureDecoder, CountsEdgesAsAsked) {
  for (const int counts : {1, 2, 4}) {
    QuadratureDecoder decoder(counts);
    int position = 0;
    for (int i = 0; i <= 40; ++i) {
      position += decoder.sample(phase(i).first, phase(i).second);
      EXPECT_FALSE(decoder.is_illegal());
    }
    EXPECT_EQ(position, 10 * counts);
    for (int i = 40; i >= -20; --i) {
      position += decoder.sample(phase(i).first, phase(i).second);
    }
    EXPECT_EQ(position, -5 * counts);
  }
}

TEST(QuadratureDecoder, NeverDriftsOnRandomWalks) {
  // The oracle: edges of the position that the counting rule passes over.
  std::mt19937 random(7);
  for (const int counts : {1, 2, 4}) {
    QuadratureDecoder decoder(counts);
    int walked = 0;
    int counted = 0;
    decoder.sample(false, false);
    for (int i = 0; i < 20000; ++i) {
      walked += static_cast<int>(random() % 3) - 1;
      counted += decoder.sample(phase(walked).first, phase(walked).second);
      // x4: every quarter; x2: A changes between quarters 0, 1 and 2, 3; x1:
      // between 0 and 1 only.
      const auto floor_div = [](int a, int b) {
        return a >= 0 ? a / b : -((b - 1 - a) / b);
      };
      const int expected = counts == 4   ? walked
                           : counts == 2 ? floor_div(walked + 1, 2)
                                         : floor_div(walked + 3, 4);
      ASSERT_EQ(counted, expected) << "at " << walked << ", x" << counts;
    }
  }
}

TEST(QuadratureDecoder, CountsNothingWhenBothChannelsChange) {
  QuadratureDecoder decoder(4);
  EXPECT_EQ(decoder.sample(true, false), 0) << "the first sample";
  EXPECT_FALSE(decoder.is_illegal());
  EXPECT_EQ(decoder.sample(false, true), 0);
  EXPECT_TRUE(decoder.is_illegal());
  EXPECT_EQ(decoder.sample(false, false), 1);
  EXPECT_FALSE(decoder.is_illegal());
}

TEST(PulseReader, ReadsColumnsOfText) {
  EXPECT_EQ(
      codes("time,a,b\n0,0,0\n1,1,0\n2,1,1\n3,0,1\n4,1,1\n", PulseFormat::csv),
      "0004");
  EXPECT_EQ(codes("0 0\n1 0\n1 1\n", PulseFormat::csv), "00") << "no header";
  EXPECT_EQ(codes("0.5;0;0\n0.6;0;1\n", PulseFormat::csv), "4") << "time first";
  EXPECT_EQ(codes("; sigrok\nTime [s],X.A,X.B,Y.A,Y.B\r\n"
                  "0,0,0,0,0\r\n1,1,0,0,0\r\n2,1,1,1,0\r\n3,1,1,0,0\r\n",
                  PulseFormat::csv),
            "016");
  EXPECT_EQ(codes("n,B,noise,A\n1,0,7,0\n2,0,7,1\n", PulseFormat::csv), "0");
  EXPECT_EQ(codes("p,q,r\n0,0,0\n0,1,0\n", PulseFormat::csv, {"q", "r"}), "0");
  EXPECT_EQ(codes("p,q,r\n0,0,0\n0,1,0\n", PulseFormat::csv, {"3", "2"}), "4");
}

TEST(PulseReader, ReadsAnalogueColumnsThroughATrigger) {
  PulseReadOptions options;
  options.low = -0.2;
  options.high = 0.3;
  const std::string text =
      "a,b\n-1,-1\n0.2,-1\n0.31,-1\n-0.1,-1\n0.9,5e-1\n0.9,0\n-0.3,0\n";
  EXPECT_EQ(codes(read_pulses(bytes_of(text), PulseFormat::csv, options)),
            "000");
  EXPECT_EQ(codes(text, PulseFormat::csv),
            "line 2: column 1 is neither 0 nor 1; for analogue values give the "
            "levels of a trigger");
}

TEST(PulseReader, NamesThePlaceOfErrorsInText) {
  const auto error = [](const std::string& text) {
    return codes(text, PulseFormat::csv);
  };
  EXPECT_EQ(error("a,b\n0,0\n1\n"),
            "line 3: column 2 is missing; the row has 1");
  EXPECT_EQ(error("a,b\n0,x\n"), "line 2: column 2 is no number");
  EXPECT_EQ(error("t,a,b\n2,0,0\n1,0,0\n"), "line 3: the time goes back");
  EXPECT_EQ(error(""), "no row of channels in the text");
  EXPECT_EQ(error("a\n0\n"), "line 1: fewer than two channels");
  EXPECT_EQ(error("p,q,r\n"),
            "line 1: which channels are A and B is not clear; name them "
            "(--channels A,B); there are p, q, r");
  EXPECT_EQ(codes("p,q,q\n", PulseFormat::csv, {"p", "q"}),
            "line 1: several channels 'q'; there are p, q, q");
  EXPECT_EQ(codes("p,q\n", PulseFormat::csv, {"p", "4"}),
            "line 1: no channel '4'; there are p, q");
}

TEST(PulseReader, TellsIllegalTransitionsWithTheirTime) {
  const Result<VectorPage> page =
      try_read("time,a,b\n0,0,0\n0.25,1,1\n0.5,1,0\n", PulseFormat::csv);
  EXPECT_EQ(codes(page), "4");
  EXPECT_TRUE(has_note(*page,
                       "1 illegal transition (both channels of an encoder at "
                       "once, not counted): line 3 (time 0.25)"));
  EXPECT_EQ(page->info.metadata.at(0).first, "unstep:pulses");
  EXPECT_EQ(page->info.metadata.at(0).second,
            "csv, x4, 3 samples, 1 counts of x, 1 illegal transitions");
}

TEST(PulseReader, ReadsValueChangeDumps) {
  const std::string head =
      "$timescale 1 us $end $scope module enc $end\n"
      "$var wire 1 ! xa $end $var wire 1 \" xb $end\n"
      "$var wire 1 # ya $end $var wire 1 $ yb $end\n"
      "$upscope $end $enddefinitions $end\n";
  EXPECT_EQ(codes(head + "#0 0! 0\" 0# 0$ #5 1! #6 1# 1\" #7 0! 0\" #9 x# 0!",
                  PulseFormat::vcd),
            "01");
  const Result<VectorPage> page =
      try_read(head + "#0 0! 0\" 0# 0$ #5 1! 1\" #7 z$", PulseFormat::vcd);
  EXPECT_TRUE(has_note(*page, "not counted): 5 us")) << codes(page);
  EXPECT_TRUE(has_note(*page, "unknown (x or z) 1 times"));
  EXPECT_EQ(
      codes(head + "#0 0! 0\" #1 1\"", PulseFormat::vcd, {"enc.xb", "enc.xa"}),
      "0");
  EXPECT_EQ(recognise_pulses(bytes_of(head)), PulseFormat::vcd);
  EXPECT_EQ(recognise_pulses(bytes_of("a,b\n")), std::nullopt);
}

TEST(PulseReader, ReadsSessionsOfSigrok) {
  const std::string session =
      make_session("probe3=B\nprobe1=A\n", std::string("\0\1\5\4\0\5", 6));
  EXPECT_EQ(codes(session, PulseFormat::sigrok), "0000");
  EXPECT_EQ(recognise_pulses(bytes_of(session)), PulseFormat::sigrok);
  const Result<VectorPage> page = try_read(session, PulseFormat::sigrok);
  EXPECT_TRUE(has_note(*page, "not counted): 2.5 us"));
  EXPECT_EQ(codes(session, PulseFormat::sigrok, {"B", "A"}), "4444");
  EXPECT_EQ(
      codes(make_session("probe9=A\nprobe1=B\n", ""), PulseFormat::sigrok),
      "metadata: probe9 is beyond the bytes of a sample");
  EXPECT_EQ(codes(test::make_zip({{"version", "2"}}), PulseFormat::sigrok),
            "not a sigrok session: no metadata");
}

TEST(PulseReader, ReadsRawStreamsOfPairs) {
  // 00 10 11 01, then 00 01 11 10.
  EXPECT_EQ(codes("\x2d\x1e", PulseFormat::raw2), "0000444");
  // Both encoders: 0000 1000 1010 1010, and one sample more to fill the byte.
  EXPECT_EQ(codes(std::string("\x08\xaa", 2), PulseFormat::raw4), "02");
  EXPECT_EQ(codes("", PulseFormat::raw2), "");
}

TEST(PulseReader, SaysFourConnectedUnlessCountsMeet) {
  EXPECT_EQ(
      try_read("0 0\n1 0\n", PulseFormat::csv)->drawing.chains[0].connectivity,
      Connectivity::four);
  const auto both =
      try_read("xa xb ya yb\n0 0 0 0\n1 0 1 0\n", PulseFormat::csv);
  EXPECT_EQ(codes(both), "1");
  EXPECT_EQ(both->drawing.chains[0].connectivity, Connectivity::eight);
  EXPECT_EQ(both->drawing.canvas, (Canvas{0, 0, YAxis::up}));
}

TEST(PulseReader, KeepsToTheLimits) {
  PulseReadOptions options;
  options.limits.max_steps = 3;
  EXPECT_EQ(codes(read_pulses(bytes_of("\x2d"), PulseFormat::raw2, options)),
            "more than the limit of 3 samples");
  options.counts = 3;
  EXPECT_EQ(codes(read_pulses(bytes_of(""), PulseFormat::raw2, options)),
            "counts of a cycle: 1, 2 or 4");
}

TEST(PulseReader, SurvivesTruncationAndFlippedBits) {
  const std::string session =
      make_session("probe1=A\nprobe2=B\n", std::string("\0\1\3\2\0\1", 6));
  const std::string whole = codes(session, PulseFormat::sigrok);
  for (std::size_t size = 0; size < session.size(); ++size) {
    const std::string cut = codes(session.substr(0, size), PulseFormat::sigrok);
    if (cut == whole) continue;  // the length of a comment that is not there
    EXPECT_FALSE(cut.empty());
    EXPECT_EQ(cut.find_first_not_of("01234567"), 0U) << size << " " << cut;
  }
  for (std::size_t bit = 0; bit < session.size() * 8; ++bit) {
    std::string bad = session;
    bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ 1 << bit % 8);
    (void)recognise_pulses(bytes_of(bad));
    EXPECT_EQ(codes(bad, PulseFormat::sigrok).find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace unstep
