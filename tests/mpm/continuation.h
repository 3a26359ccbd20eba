#pragma once

#include "mpm/simulation.h"

#include <gtest/gtest.h>

/// A run cut and continued gives the same bits as an uninterrupted one: state, ledger, snapshots, gauges, sides,
/// motion, and what is kept of the body.
namespace wetfront::mpm::test {

inline void expect_same_motion(const meshes::MotionRow& one, const meshes::MotionRow& other) {
  EXPECT_EQ(one.time, other.time);
  EXPECT_EQ(one.kinetic, other.kinetic);
  EXPECT_EQ(one.potential, other.potential);
  EXPECT_EQ(one.stress_work, other.stress_work);
  EXPECT_EQ(one.load_work, other.load_work);
  EXPECT_EQ(one.resistance, other.resistance);
  EXPECT_EQ(one.drift, other.drift);
  EXPECT_EQ(one.motion, other.motion);
  EXPECT_EQ(one.momentum, other.momentum);
  EXPECT_EQ(one.impulse, other.impulse);
  EXPECT_EQ(one.reaction, other.reaction);
  EXPECT_EQ(one.momentum_drift, other.momentum_drift);
}

inline void expect_same_body(const BodyRecord& a, const BodyRecord& b) {
  ASSERT_EQ(a.riders.size(), b.riders.size());
  for (std::size_t k = 0; k < a.riders.size(); ++k) {
    EXPECT_EQ(a.riders[k].name, b.riders[k].name);
    EXPECT_EQ(a.riders[k].start, b.riders[k].start);
    EXPECT_EQ(a.riders[k].time, b.riders[k].time);
    EXPECT_EQ(a.riders[k].place, b.riders[k].place);
    EXPECT_EQ(a.riders[k].velocity, b.riders[k].velocity);
  }
  ASSERT_EQ(a.stages.size(), b.stages.size());
  for (std::size_t k = 0; k < a.stages.size(); ++k) {
    EXPECT_EQ(a.stages[k].name, b.stages[k].name);
    EXPECT_EQ(a.stages[k].scheme, b.stages[k].scheme);
    EXPECT_EQ(a.stages[k].begin, b.stages[k].begin);
    EXPECT_EQ(a.stages[k].end, b.stages[k].end);
    EXPECT_EQ(a.stages[k].ended_by, b.stages[k].ended_by);
    EXPECT_EQ(a.stages[k].reason, b.stages[k].reason);
  }
  ASSERT_EQ(a.pictures.size(), b.pictures.size());
  for (std::size_t k = 0; k < a.pictures.size(); ++k) {
    EXPECT_EQ(a.pictures[k].of, b.pictures[k].of);
    EXPECT_EQ(a.pictures[k].displacement, b.pictures[k].displacement);
    EXPECT_EQ(a.pictures[k].snapshot.time, b.pictures[k].snapshot.time);
  }
}

inline void expect_same_bits(const State& a, const State& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.stage, b.stage);
  ASSERT_EQ(a.fields.size(), b.fields.size());
  for (const auto& [name, values] : a.fields) EXPECT_EQ(values, b.fields.at(name)) << name;
  ASSERT_EQ(a.history.ledger.size(), b.history.ledger.size());
  for (std::size_t k = 0; k < a.history.ledger.size(); ++k) {
    EXPECT_EQ(a.history.ledger[k].stored, b.history.ledger[k].stored);
    EXPECT_EQ(a.history.ledger[k].run_off, b.history.ledger[k].run_off);
  }
  ASSERT_EQ(a.history.snapshots.size(), b.history.snapshots.size());
  for (std::size_t k = 0; k < a.history.snapshots.size(); ++k) {
    EXPECT_EQ(a.history.snapshots[k].node_pressure, b.history.snapshots[k].node_pressure);
    EXPECT_EQ(a.history.snapshots[k].points.position, b.history.snapshots[k].points.position);
  }
  ASSERT_EQ(a.history.gauges.size(), b.history.gauges.size());
  for (std::size_t k = 0; k < a.history.gauges.size(); ++k)
    EXPECT_EQ(a.history.gauges[k].pressure, b.history.gauges[k].pressure);
  ASSERT_EQ(a.history.sides.size(), b.history.sides.size());
  for (std::size_t s = 0; s < b.history.sides.size(); ++s) {
    EXPECT_EQ(a.history.sides[s].outflow, b.history.sides[s].outflow);
    EXPECT_EQ(a.history.sides[s].run_off, b.history.sides[s].run_off);
    EXPECT_EQ(a.history.sides[s].evaporated, b.history.sides[s].evaporated);
  }
  ASSERT_EQ(a.history.motion.size(), b.history.motion.size());
  for (std::size_t k = 0; k < a.history.motion.size(); ++k)
    expect_same_motion(a.history.motion[k], b.history.motion[k]);
  expect_same_body(a.body, b.body);
  EXPECT_EQ(a.history.counters, b.history.counters);
}

/// Cuts at every step whose number is `first` modulo `stride`, at four places or more.
inline void expect_continuation(const Problem<2>& problem, long stride, long first = 0) {
  Simulation<2> whole(problem);
  std::vector<State> cuts;
  for (long step = 0; !whole.finished(); ++step) {
    if (step % stride == first) cuts.push_back(whole.state());
    whole.step();
  }
  const State end = whole.state();
  ASSERT_GE(cuts.size(), 4u);
  for (const State& cut : cuts) {
    Simulation<2> rest(problem, cut);
    while (!rest.finished()) rest.step();
    expect_same_bits(rest.state(), end);
  }
}

/// Cuts at the first step that ends at a time [s] or later.
inline void expect_continuation_at(const Problem<2>& problem, double time) {
  Simulation<2> whole(problem);
  while (whole.time() < time) whole.step();
  Simulation<2> continued(problem, whole.state());
  for (Simulation<2>* simulation : {&whole, &continued})
    while (!simulation->finished()) simulation->step();
  expect_same_bits(continued.state(), whole.state());
}

}  // namespace wetfront::mpm::test
