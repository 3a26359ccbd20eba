// What the suite's bookkeeping does with a case that goes wrong: no such case may look like a pass.
#include "verification/suites/case_book.h"
#include "verification/suites/reference/srivastava_yeh_problem.h"
#include "verification/suites/reference_suite.h"
#include "verification/suites/setups.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace wetfront::verification {
namespace {

using reports::Verdict;

Verdict verdict_of(const std::function<void(CaseBook&)>& run) {
  return run_case({"made_up", "Made up", "-", "-", Effort::quick, run}).verdict;
}

TEST(CaseBook, JudgesBothSidesAndRefusesNotANumber) {
  const Gate gate{0.1, "1", "-"};
  EXPECT_EQ(verdict_of([&](CaseBook& book) { book.expect("q", "-", 1.09, 1, gate); }), Verdict::pass);
  EXPECT_EQ(verdict_of([&](CaseBook& book) { book.expect("q", "-", 0.89, 1, gate); }), Verdict::fail);
  EXPECT_EQ(verdict_of([&](CaseBook& book) { book.expect("q", "-", 1.11, 1, gate); }), Verdict::fail);
  EXPECT_EQ(verdict_of([&](CaseBook& book) { book.expect("q", "-", std::nan(""), 1, gate); }), Verdict::fail);
  const OrderGate order{1.9, 2.1, "-"};
  EXPECT_EQ(verdict_of([&](CaseBook& book) { book.judge_order("o", "-", 1.95, order); }), Verdict::pass);
  EXPECT_EQ(verdict_of([&](CaseBook& book) { book.judge_order("o", "-", 2.5, order); }), Verdict::fail);
  EXPECT_EQ(verdict_of([&](CaseBook& book) { book.judge_order("o", "-", 1.0, order); }), Verdict::fail);
}

TEST(CaseBook, AnExceptionIsAFailureThatKeepsWhatWasWrittenDown) {
  const auto record = run_case({"made_up", "Made up", "-", "-", Effort::quick, [](CaseBook& book) {
                                  book.judge("q", "-", 0, {1, "1", "-"});
                                  throw std::runtime_error("the pump broke");
                                }});
  EXPECT_EQ(record.verdict, Verdict::fail);
  ASSERT_EQ(record.findings.size(), 2U);
  EXPECT_EQ(record.findings[1].explanation, "the pump broke");
}

TEST(CaseBook, BalanceCountsWhatPassesBothWays) {
  meshes::FieldHistory history;  // 2 in through the top and 2 out through the base; 1e-6 went missing on the way
  history.ledger = {{0, 0, 0, 0, 0, 10, 0}, {1, 2, 2, 0, 2, 10 - 1e-6, 0}};
  history.sides = {{"top", "rain", {0, 2}, {0, 0}, {0, 0}, {0, 0}, {0, 0}},
                   {"base", "head", {0, 0}, {0, 0}, {0, 2}, {0, 0}, {0, 0}}};
  EXPECT_NEAR(relative_imbalance(history), 1e-6 / 4, 1e-12);
  history.sides[1].outflow = {0, -2};  // came in instead
  EXPECT_NEAR(relative_imbalance(history), 1e-6 / 4, 1e-12);
}

/// A gate that cannot fail is none: with Ks wrong by 1 % the closed form must notice.
TEST(SuiteFaults, OnePerCentOfConductivityFails) {
  const auto layer = srivastava_yeh_layer(10, true);
  const exact::SrivastavaYehSolution solution(layer);
  for (const double factor : {1.0, 1.01}) {
    auto problem = srivastava_yeh_problem(layer, 100);
    problem.soils[0].saturated_conductivity *= factor;
    const auto history = fem_reference::solve(problem);
    double worst = 0, size = 0;
    for (std::size_t i = 0; i <= 100; ++i) {
      const double exact = solution.head(problem.mesh.nodes[i][0], 20 * hour);
      worst += std::pow(history.snapshots[4].node_pressure[i] / 9810 - exact, 2), size += exact * exact;
    }
    EXPECT_EQ(std::sqrt(worst / size) <= 3.5e-4, factor == 1.0) << std::sqrt(worst / size);
  }
}

TEST(ReferenceSuite, NamesAreFolderNamesAndUsedOnce) {
  std::set<std::string> names;
  for (const Case& test : reference_suite()) {
    EXPECT_EQ(test.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos) << test.name;
    EXPECT_TRUE(names.insert(test.name).second) << test.name;
    EXPECT_FALSE(test.title.empty() || test.requirement.empty() || test.source.empty()) << test.name;
  }
}

}  // namespace
}  // namespace wetfront::verification
