#include <gtest/gtest.h>

#include "machine/photomask.h"

namespace unstep::machine {
namespace {

MaskJob part(int dots) {
  MaskJob job;
  job.columns = job.rows = dots;
  return job;
}

TEST(Photomask, OfTheArticleIsWithin1_2UmAnd30Minutes) {
  const auto report = expose_mask(MaskJob{}, Plant{}, 1);
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->dots, 114 * 114);
  EXPECT_LE(report->worst_um, kMaskErrorUm);
  EXPECT_LE(report->seconds, kMaskSeconds);
  // Not faster than the way at 1 cm/s.
  EXPECT_GT(report->seconds, 114 * 113 / 10.0);
  EXPECT_LT(report->top_speed_um, 10'100);
}

TEST(Photomask, IsTheSameForASeed) {
  const auto one = expose_mask(part(5), Plant{}, 9);
  const auto same = expose_mask(part(5), Plant{}, 9);
  const auto other = expose_mask(part(5), Plant{}, 10);
  ASSERT_TRUE(one && same && other);
  EXPECT_EQ(one->worst_um, same->worst_um);
  EXPECT_EQ(one->seconds, same->seconds);
  EXPECT_NE(one->worst_um, other->worst_um);
}

TEST(Photomask, MoreNoiseBreaksIt) {
  const auto silent = expose_mask(part(10), Plant{}.noisier(0), 1);
  const auto usual = expose_mask(part(10), Plant{}, 1);
  const auto noisy = expose_mask(part(10), Plant{}.noisier(6), 1);
  ASSERT_TRUE(silent && usual && noisy);
  EXPECT_LT(silent->worst_um, 0.3);
  EXPECT_LE(usual->worst_um, kMaskErrorUm);
  EXPECT_GT(noisy->worst_um, kMaskErrorUm);
}

TEST(Photomask, EveryNoiseAloneBreaksItWhenLargeEnough) {
  Plant forced;
  forced.force_noise_n *= 50;
  Plant shaken;
  shaken.head_noise_um *= 6;
  for (const Plant& plant : {forced, shaken}) {
    const auto report = expose_mask(part(10), plant, 1);
    // A carriage that never comes to rest is broken too.
    if (report) {
      EXPECT_GT(report->worst_um, kMaskErrorUm);
    }
  }
}

TEST(Photomask, FlashOfAMillisecondSmearsTenUm) {
  MaskJob job = part(3);
  job.width_us = 1000;
  job.rate = 1000;
  const auto report = expose_mask(job, Plant{}, 1);
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_NEAR(report->smear_um, 10, 0.2);
  EXPECT_GT(report->worst_um, kMaskErrorUm);
}

TEST(Photomask, PlanTurnsAtEveryRow) {
  MaskJob job = part(3);
  job.rows = 2;
  const auto rows = plan_mask(job);
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 2U);
  EXPECT_EQ((*rows)[0].direction, 1);
  EXPECT_LT((*rows)[0].start, (*rows)[0].first);
  EXPECT_EQ((*rows)[1].direction, -1);
  EXPECT_EQ((*rows)[1].y, 12'500);
  EXPECT_GT((*rows)[1].start, (*rows)[1].first);
}

TEST(Photomask, RefusesWhatTheMachineCannotDo) {
  const auto code = [](auto change) {
    MaskJob job;
    change(job);
    const auto rows = plan_mask(job);
    return !rows && rows.error().code == ErrorCode::out_of_range;
  };
  EXPECT_TRUE(code([](MaskJob& j) { j.rows = 0; }));
  EXPECT_TRUE(code([](MaskJob& j) { j.columns = 1 << 30; }));
  EXPECT_TRUE(code([](MaskJob& j) { j.rate = 1001; }));
  EXPECT_TRUE(code([](MaskJob& j) { j.width_us = 1001; }));
  EXPECT_TRUE(code([](MaskJob& j) { j.pitch_pulses = 100; }));
  EXPECT_TRUE(code([](MaskJob& j) { j.columns = 671; }));
  EXPECT_FALSE(code([](MaskJob&) {}));
}

}  // namespace
}  // namespace unstep::machine
