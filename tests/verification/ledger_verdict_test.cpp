// What a ledger of differences concludes from its shares, on ledgers made by hand, and what its page shows of them.
#include "verification/ledger/difference_ledger.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace wetfront::verification {
namespace {

using reports::Verdict;
using testing::HasSubstr;

Share share(const std::string& cause, double value, double doubt, bool converged = true, bool probed = true) {
  return {cause, value, doubt, converged, probed, ""};
}

/// 10 mm of difference under a gate of 5 mm.
QuantityLedger ledger_of(const std::vector<Share>& shares) {
  QuantityLedger entry;
  entry.quantity = "front_position";
  entry.description = "elevation of the wetting front";
  entry.unit = "m";
  entry.candidate = 1.010;
  entry.reference = 1.000;
  entry.tolerance = 0.005;
  entry.shares = shares;
  return entry;
}
QuantityLedger concluded(const std::vector<Share>& shares) {
  QuantityLedger entry = ledger_of(shares);
  conclude(entry);
  return entry;
}

TEST(LedgerVerdict, WhatIsExplainedPasses) {
  const QuantityLedger entry = concluded({share("mesh", 0.009, 0.0001)});
  EXPECT_EQ(entry.verdict, Verdict::pass);
  EXPECT_NEAR(entry.remainder, 0.001, 1e-12);
  EXPECT_EQ(entry.explanation, "");
  EXPECT_FALSE(entry.cancels);
}

TEST(LedgerVerdict, AProbeThatDoesNotConvergeLeavesItOpen) {
  const QuantityLedger entry = concluded({share("mesh", 0.009, 0.002, false)});
  EXPECT_EQ(entry.verdict, Verdict::inconclusive) << "though the remainder is small";
  EXPECT_THAT(entry.explanation, HasSubstr("does not approach a limit"));
  EXPECT_EQ(concluded({share("boundary flux", 0.0095, 0), share("mesh", 0, 0.0005, false)}).verdict, Verdict::pass)
      << "its doubt is below a tenth of all there is: it decides nothing";
  EXPECT_EQ(concluded({share("boundary flux", 0.002, 0), share("mesh", 0, 0.0015, false)}).verdict,
            Verdict::inconclusive)
      << "what is not known must not fail as unexplained";
}

TEST(LedgerVerdict, ALargeRemainderFails) {
  const QuantityLedger entry = concluded({share("mesh", 0.006, 0.0001), share("time step", 0, 0)});
  EXPECT_EQ(entry.verdict, Verdict::fail) << "4 of 10 mm are nobody's";
  EXPECT_THAT(entry.explanation, HasSubstr("Something that no probe knows"));
  EXPECT_EQ(concluded({share("mesh", 0.006, 0.002)}).verdict, Verdict::inconclusive)
      << "its own doubt reaches the limit";
}

TEST(LedgerVerdict, ALargeRemainderThatMayBeAnUnmeasuredCauseIsOpen) {
  const QuantityLedger entry = concluded({share("boundary flux", 0.006, 0), share("mesh", 0, 0, true, false)});
  EXPECT_EQ(entry.verdict, Verdict::inconclusive);
  EXPECT_THAT(entry.explanation, HasSubstr("a cause that could not be measured here"));
}

TEST(LedgerVerdict, ATrifleNeedsNoCause) {
  QuantityLedger entry = ledger_of({});
  entry.candidate = 1.0004;
  conclude(entry);
  EXPECT_EQ(entry.verdict, Verdict::pass);
  EXPECT_THAT(entry.explanation, HasSubstr("nothing to explain"));
}

TEST(LedgerVerdict, CausesThatHideEachOtherAreSaid) {
  const QuantityLedger entry = concluded({share("boundary flux", -0.02, 0), share("time step", 0.03, 0)});
  EXPECT_TRUE(entry.cancels);
  EXPECT_EQ(entry.verdict, Verdict::pass);
  EXPECT_THAT(entry.explanation, HasSubstr("hide each other"));
}

TEST(LedgerVerdict, TheReferencesDoubtIsTheRemainders) {
  QuantityLedger entry = ledger_of({share("mesh", 0.006, 0.0001)});
  entry.reference_bound = 0.002;
  conclude(entry);
  EXPECT_NEAR(entry.uncertainty, 0.0021, 1e-12);
  EXPECT_EQ(entry.verdict, Verdict::inconclusive) << "4 mm left, 2.5 mm allowed, 2.1 mm in doubt";
}

TEST(LedgerVerdict, ThePageHasARowForEachSideOfTheReference) {
  QuantityLedger entry = ledger_of({share("mesh", 0.009, 0.0001)});
  entry.reference_bound = 0.0008;
  entry.reference_mesh = share("reference's mesh", -0.0004, 0.0005);
  entry.reference_steps = share("reference's time step", 0.00015, 0.0003);
  conclude(entry);
  DifferenceLedger ledger;
  ledger.quantities = {entry};
  reports::Record record;
  add_ledger(record, ledger);
  const auto& rows = record.tables.back().rows;
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_THAT(rows[1], testing::ElementsAre("reference's mesh", "", "0.5", "", HasSubstr("changes it by -0.4 mm")));
  EXPECT_THAT(rows[2], testing::ElementsAre("reference's time step", "", "0.3", "", HasSubstr("by 0.15 mm")));
  EXPECT_EQ(rows[3][0], "remainder");
  ASSERT_EQ(record.findings.size(), 1u);
  EXPECT_EQ(record.findings[0].quantity, "ledger_front_position");
}

}  // namespace
}  // namespace wetfront::verification
