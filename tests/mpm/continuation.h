#pragma once

#include "mpm/simulation.h"

#include <gtest/gtest.h>

/// A run cut and continued gives the same bits as an uninterrupted one: state, ledger, snapshots, gauges, sides,
/// motion, and what is kept of the body.
namespace wetfront::mpm::test {

/// same(one, other) for what stands at the same place in both.
template <class Items, class Same>
void expect_same_each(const Items& one, const Items& other, const Same& same) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t k = 0; k < one.size(); ++k) same(one[k], other[k]);
}

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
  expect_same_each(a.riders, b.riders, [](const Rider& one, const Rider& other) {
    EXPECT_EQ(one.name, other.name);
    EXPECT_EQ(one.start, other.start);
    EXPECT_EQ(one.time, other.time);
    EXPECT_EQ(one.place, other.place);
    EXPECT_EQ(one.velocity, other.velocity);
  });
  expect_same_each(a.stages, b.stages, [](const StageSpan& one, const StageSpan& other) {
    EXPECT_EQ(one.name, other.name);
    EXPECT_EQ(one.scheme, other.scheme);
    EXPECT_EQ(one.begin, other.begin);
    EXPECT_EQ(one.end, other.end);
    EXPECT_EQ(one.ended_by, other.ended_by);
    EXPECT_EQ(one.reason, other.reason);
  });
  expect_same_each(a.pictures, b.pictures, [](const Picture& one, const Picture& other) {
    EXPECT_EQ(one.of, other.of);
    EXPECT_EQ(one.displacement, other.displacement);
    EXPECT_EQ(one.snapshot.time, other.snapshot.time);
  });
}

inline void expect_same_history(const meshes::FieldHistory& a, const meshes::FieldHistory& b) {
  expect_same_each(a.ledger, b.ledger, [](const meshes::LedgerRow& one, const meshes::LedgerRow& other) {
    EXPECT_EQ(one.stored, other.stored);
    EXPECT_EQ(one.run_off, other.run_off);
  });
  expect_same_each(a.snapshots, b.snapshots, [](const meshes::Snapshot& one, const meshes::Snapshot& other) {
    EXPECT_EQ(one.node_pressure, other.node_pressure);
    EXPECT_EQ(one.points.position, other.points.position);
  });
  expect_same_each(a.gauges, b.gauges, [](const meshes::Gauge& one, const meshes::Gauge& other) {
    EXPECT_EQ(one.pressure, other.pressure);
  });
  expect_same_each(a.sides, b.sides, [](const meshes::SideLedger& one, const meshes::SideLedger& other) {
    EXPECT_EQ(one.outflow, other.outflow);
    EXPECT_EQ(one.run_off, other.run_off);
    EXPECT_EQ(one.evaporated, other.evaporated);
  });
  expect_same_each(a.motion, b.motion, expect_same_motion);
  EXPECT_EQ(a.counters, b.counters);
}

inline void expect_same_bits(const State& a, const State& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.stage, b.stage);
  ASSERT_EQ(a.fields.size(), b.fields.size());
  for (const auto& [name, values] : a.fields) EXPECT_EQ(values, b.fields.at(name)) << name;
  expect_same_history(a.history, b.history);
  expect_same_body(a.body, b.body);
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
