#include "codec/far_flag_model.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace unstep::codec {
namespace {

TEST(FarFlagModel, AnswersAsTheKnownCounterAtFirst) {
  for (const int p : {40, 900, 20000, 60000}) {
    FarFlagModel model(3);
    model.begin_row(0);
    entropy::Counter known{static_cast<std::uint16_t>(p), 10};
    EXPECT_NEAR(model.predict(known, 1, {}), p, p / 50 + 2);
  }
}

TEST(FarFlagModel, ExpectsMoreStartsWhereTheyCame) {
  FarFlagModel model(40);
  entropy::Counter known{600, 255};
  for (std::int32_t y = 0; y < 400; ++y) {
    model.begin_row(y);
    for (std::size_t word = 0; word < 40; ++word) {
      known = {600, 255};
      model.predict(known, word, {});
      model.update(word < 10 && (static_cast<std::size_t>(y) + word) % 8 == 0);
    }
  }
  model.begin_row(400);
  known = {600, 255};
  const int crowded = model.predict(known, 5, {});
  const int empty = model.predict(known, 30, {});
  EXPECT_GT(crowded, 65536 / 20);
  EXPECT_LT(empty, 65536 / 500);
}

TEST(FarFlagModel, ColoursAndEndWordsAreTheirOwn) {
  FarFlagModel model(1);
  entropy::Counter known{600, 255};
  for (std::int32_t y = 0; y < 200; ++y) {
    model.begin_row(y);
    for (const bool ink : {false, true}) {
      known = {600, 255};
      model.predict(known, 0, {ink, 3, 0, {7, 7, 7}});
      model.update(ink);
    }
  }
  model.begin_row(200);
  known = {600, 255};
  const int paper = model.predict(known, 0, {false, 3, 0, {7, 7, 7}});
  EXPECT_GT(model.predict(known, 0, {true, 3, 0, {7, 7, 7}}), 20 * paper);
}

}  // namespace
}  // namespace unstep::codec
