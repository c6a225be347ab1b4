#include "formats/vcd_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace unstep {
namespace {

const std::string kHeader =
    "$date Mon May 5 2025 $end\n"
    "$timescale 10 us $end\n"
    "$scope module top $end\n"
    "$scope begin enc $end\n"
    "$var wire 1 ! A $end\n"
    "$var wire 1 ab CH 2 $end\n"
    "$upscope $end\n"
    "$var reg 4 # bus [3:0] $end\n"
    "$var wire 1 $ bus[7] $end\n"
    "$var wire 1 ! alias $end\n"
    "$var real 64 % speed $end\n"
    "$upscope $end\n"
    "$enddefinitions $end\n";

VcdReader open(const std::string& text) {
  Result<VcdReader> file = VcdReader::open(text, {});
  EXPECT_TRUE(file) << file.error().message;
  return *std::move(file);
}

/// "time:net=level" of every bit of the width.
std::vector<std::string> changes_of(VcdReader& file, std::string* error) {
  std::vector<std::string> all;
  for (;;) {
    const auto change = file.next();
    if (!change && error != nullptr) *error = change.error().message;
    if (!change || !*change) return all;
    const VcdChange& c = **change;
    std::string text = std::to_string(c.time) + ":" + std::to_string(c.net);
    text += '=';
    for (unsigned bit = 4; bit-- > 0;) {
      const std::optional<bool> level = VcdProbe{c.net, bit}.level(c);
      text += level ? (*level ? '1' : '0') : 'x';
    }
    all.push_back(text);
  }
}

std::string error_of(const std::string& text, const DecodeLimits& limits = {}) {
  Result<VcdReader> file = VcdReader::open(text, limits);
  if (!file) return file.error().message;
  std::string error = "no error";
  changes_of(*file, &error);
  return error;
}

TEST(VcdReader, NamesSignalsByTheirScopes) {
  const VcdReader file = open(kHeader);
  EXPECT_TRUE(file.timescale().known);
  EXPECT_EQ(file.timescale().magnitude, 10);
  EXPECT_EQ(file.timescale().exponent, -6);
  std::vector<std::string> names;
  for (const VcdSignal& signal : file.signals()) names.push_back(signal.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"top.enc.A", "top.enc.CH 2", "top.bus",
                                      "top.bus[7]", "top.alias", "top.speed"}));
}

TEST(VcdReader, FindsSignalsByWholeAndPartialNames) {
  const VcdReader file = open(kHeader);
  const auto at = [&file](std::string_view name) {
    const Result<VcdProbe> probe = file.find(name);
    return probe ? std::to_string(probe->net) + "." + std::to_string(probe->bit)
                 : probe.error().message;
  };
  EXPECT_EQ(at("top.enc.A"), "0.0");
  EXPECT_EQ(at("enc.A"), "0.0");
  EXPECT_EQ(at("A"), "0.0");
  EXPECT_EQ(at("alias"), "0.0");
  EXPECT_EQ(at("CH 2"), "1.0");
  EXPECT_EQ(at("bus[2]"), "2.2");
  EXPECT_EQ(at("top.bus[0]"), "2.0");
  EXPECT_EQ(at("bus[7]"), "3.0") << "a signal of its own";
  EXPECT_EQ(at("bus[4]"),
            "no signal of one bit is named 'bus[4]' (there are 'top.enc.A', "
            "'top.enc.CH 2', 'top.bus' of 4 bits, 'top.bus[7]', 'top.alias', "
            "'top.speed' of 64 bits)");
  EXPECT_EQ(at("bus").substr(0, 35), "no signal of one bit is named 'bus'");
  EXPECT_EQ(at("nc.A").substr(0, 36), "no signal of one bit is named 'nc.A'");
}

TEST(VcdReader, ChoosesNoSignalAmongSeveral) {
  const VcdReader file = open(
      "$scope module x $end $var wire 1 ! a $end $upscope $end\n"
      "$scope module y $end $var wire 1 \" a $end $upscope $end\n"
      "$enddefinitions $end");
  EXPECT_FALSE(file.timescale().known);
  EXPECT_EQ(file.find("a").error().message,
            "'a' names several signals; give the whole name");
  EXPECT_EQ(file.find("y.a")->net, 1U);
}

TEST(VcdReader, GivesChangesInOrder) {
  const std::string text =
      kHeader +
      "#0 $dumpvars 0! xab b01x0 # 1$ r1.5 % $end\n"
      "#10\n1!\nb1 #\n$comment 0! $end\nsidle %\nBz #\nbx1 #\nb00001010 #\n"
      "#18446744073709551615 Zab";
  VcdReader file = open(text);
  EXPECT_EQ(changes_of(file, nullptr),
            (std::vector<std::string>{"0:0=0000", "0:1=000x", "0:2=01x0",
                                      "0:3=0001", "10:0=0001", "10:2=0001",
                                      "10:2=xxxx", "10:2=xxx1", "10:2=1010",
                                      "18446744073709551615:1=000x"}));
  EXPECT_EQ(file.time(), 18446744073709551615U);
}

TEST(VcdReader, NamesThePlaceOfErrors) {
  const std::string& head = kHeader;
  EXPECT_EQ(error_of("#0\n0!"), "does not begin as a VCD file does");
  EXPECT_EQ(error_of("$datex $end"), "does not begin as a VCD file does");
  EXPECT_EQ(error_of("$date today"), "line 1, column 1: no $end after it");
  EXPECT_EQ(error_of("$date $end"),
            "line 1, column 11: the file ends before $enddefinitions");
  EXPECT_EQ(error_of("$date $end\n #0"),
            "line 2, column 2: '#0' before $enddefinitions");
  EXPECT_EQ(error_of("$timescale 3 us $end"),
            "line 1, column 1: $timescale is not 1, 10 or 100 of s to fs");
  EXPECT_EQ(error_of("$var wire ! a $end"),
            "line 1, column 1: $var needs a kind, a width, a code and a name");
  EXPECT_EQ(error_of("$var wire 1 ! a $end\n$var wire 2 ! b $end"),
            "line 2, column 1: code '!' has two widths");
  EXPECT_EQ(error_of("$scope x $end"),
            "line 1, column 1: $scope needs a kind and a name");
  EXPECT_EQ(error_of("$comment $end $upscope $end"),
            "line 1, column 15: $upscope without $scope");
  EXPECT_EQ(error_of(head + "#5\n#4"),
            "line 15, column 1: time goes back from 5 to 4");
  EXPECT_EQ(error_of(head + "#18446744073709551616"),
            "line 14, column 1: #18446744073709551616 is no time of 0 to "
            "2^64 - 1");
  EXPECT_EQ(error_of(head + "#1 0?"),
            "line 14, column 4: no $var has the code '?'");
  EXPECT_EQ(error_of(head + "b1"),
            "line 14, column 1: no $var has the code ''");
  EXPECT_EQ(error_of(head + "b10101 #"),
            "line 14, column 1: a value of 5 bits for 4");
  EXPECT_EQ(error_of(head + "b102 #"),
            "line 14, column 1: a vector of other digits than 0, 1, x and z");
  EXPECT_EQ(error_of(head + "hello"),
            "line 14, column 1: 'hello' is no change of value");
}

TEST(VcdReader, KeepsToTheMemoryLimit) {
  std::string deep;
  for (int i = 0; i < 2000; ++i) deep += "$scope module level $end\n";
  DecodeLimits limits;
  limits.max_memory = 1 << 20;
  EXPECT_EQ(error_of(deep + "$enddefinitions $end", limits).substr(0, 10),
            "line 581, ");
  EXPECT_EQ(error_of(deep, limits).find("\n"), std::string::npos);
}

TEST(VcdReader, IsSoundOnTruncatedAndChangedText) {
  const std::string whole = kHeader + "#0 0! b01x0 # 1ab\n#10 1! r1 % 0ab\n";
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_EQ(error_of(whole.substr(0, size)).find('\n'), std::string::npos);
    for (const char c : {'$', '#', '\0', '\xff', ' '}) {
      std::string changed = whole;
      changed[size] = c;
      EXPECT_EQ(error_of(changed).find('\n'), std::string::npos);
    }
  }
  for (std::size_t size = 0; size + 4 < kHeader.size(); ++size) {
    EXPECT_FALSE(VcdReader::open(kHeader.substr(0, size), {})) << size;
  }
}

}  // namespace
}  // namespace unstep
