#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "program/travel_order.h"
#include "unstep/program.h"

namespace unstep {
namespace {

using program::Leg;
using program::short_order;
using program::travel_of;
using program::Trip;

std::vector<Trip> random_trips(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto coordinate = [&] {
    return static_cast<std::int32_t>(random() % 1000);
  };
  std::vector<Trip> trips(count);
  for (Trip& trip : trips) {
    trip = {{coordinate(), coordinate()}, {coordinate(), coordinate()}};
    if (random() % 4 == 0) trip.to = trip.from;
  }
  return trips;
}

/// Over all orders and turns.
double shortest(const std::vector<Trip>& trips) {
  std::vector<Leg> order;
  for (std::uint32_t i = 0; i < trips.size(); ++i) order.push_back({i, false});
  double best = travel_of(trips, order, {});
  do {
    for (unsigned turns = 0; turns < 1U << trips.size(); ++turns) {
      for (std::size_t i = 0; i < order.size(); ++i) {
        order[i].turned = (turns >> i & 1) != 0;
      }
      best = std::min(best, travel_of(trips, order, {}));
    }
  } while (std::ranges::next_permutation(order, {}, &Leg::trip).found);
  return best;
}

TEST(Travel, IsNearTheShortestOfSmallDrawings) {
  double sum = 0;
  double least = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const std::vector<Trip> trips = random_trips(1 + seed % 5, seed);
    sum += travel_of(trips, short_order(trips, {}), {});
    least += shortest(trips);
  }
  EXPECT_LE(sum, 1.15 * least);
}

TEST(Travel, VisitsEverythingOnceAndIsMuchShorter) {
  const std::vector<Trip> trips = random_trips(2000, 5);
  const std::vector<Leg> order = short_order(trips, {});
  ASSERT_EQ(order.size(), trips.size());
  std::vector<Leg> given;
  std::vector<bool> seen(trips.size());
  for (std::uint32_t i = 0; i < trips.size(); ++i) given.push_back({i, false});
  for (const Leg leg : order) {
    EXPECT_FALSE(seen[leg.trip]);
    seen[leg.trip] = true;
  }
  EXPECT_LT(travel_of(trips, order, {}), 0.06 * travel_of(trips, given, {}));
}

TEST(Travel, TurnsPathsSoThatTheyDrawTheSame) {
  Drawing drawing;
  drawing.canvas = {100, 100, YAxis::down};
  Path far;
  far.origin = {90, 90};
  far.elements = {{Path::Kind::segment, {-10, 0}, {}},
                  {Path::Kind::arc, {}, {{0, -5}, {-5, -5}, true}}};
  Path near;
  near.origin = {60, 60};
  near.elements = {{Path::Kind::segment, {-50, -50}, {}}};
  drawing.paths = {far, near};
  const TravelReport report = order_travel(drawing);
  EXPECT_LT(report.after, report.before);
  ASSERT_EQ(drawing.paths.size(), 2U);
  EXPECT_EQ(drawing.paths[0].origin, (Point{10, 10}));
  EXPECT_EQ(drawing.paths[0].elements[0].segment, (Segment{50, 50}));
  EXPECT_EQ(drawing.paths[1].origin, (Point{75, 85}));
  EXPECT_EQ(drawing.paths[1].elements[0].arc, (Arc{{5, 0}, {5, 5}, false}));
  EXPECT_EQ(drawing.paths[1].elements[1].segment, (Segment{10, 0}));
}

TEST(Travel, TurnsChainsAndKeepsClosedOnes) {
  Drawing drawing;
  drawing.canvas = {100, 100, YAxis::down};
  drawing.chains = {
      {{50, 50}, Connectivity::eight, true, {0, 2, 4, 6}},
      {{9, 5}, Connectivity::eight, false, {4, 4, 5, 5}},
  };
  order_travel(drawing);
  EXPECT_EQ(drawing.chains[0].origin, (Point{5, 7}));
  EXPECT_EQ(drawing.chains[0].steps, (std::vector<Step>{1, 1, 0, 0}));
  EXPECT_EQ(drawing.chains[1].steps, (std::vector<Step>{0, 2, 4, 6}));
  Drawing empty;
  EXPECT_EQ(order_travel(empty).after, 0);
}

}  // namespace
}  // namespace unstep
