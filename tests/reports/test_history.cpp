#include "reports/junit.h"
#include "reports/run_history.h"
#include "reports/whole_file.h"
#include "tests/reports/sample_record.h"

#include <gmock/gmock.h>

#include <fstream>

namespace wetfront::reports {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The sample run of a day, its first finding off by `error`.
Record run_of(int day, double error) {
  Record record = testing::sample_record();
  record.provenance["date"] = "2026-11-" + std::to_string(day) + " 14:02:00 UTC";
  record.findings[0].error = error;
  return record;
}

TEST(History, KeepsEveryRunOnce) {
  const TemporaryFolder desk;
  for (const int day : {20, 21, 22}) remember(run_of(day, 1e-3 * day), desk.path());
  remember(run_of(22, 22e-3), desk.path());  // rendered again: no run of its own
  const auto runs = past_runs(desk.path());
  ASSERT_EQ(runs.size(), 3U);
  EXPECT_EQ(runs[0].date, "2026-11-20 14:02:00 UTC");
  EXPECT_EQ(runs[2].commit, "5e9c152d0b7c4f1e8a0d");
  EXPECT_EQ(runs[1].verdict, Verdict::fail);
  ASSERT_EQ(runs[1].values.size(), 7U);  // the eighth finding is shown, not gated
  EXPECT_EQ(runs[1].values[0].error, 21e-3);
  EXPECT_EQ(runs[1].values[1].quantity, "pressure_l2");
  EXPECT_EQ(runs[1].values[1].number, 1);
  EXPECT_EQ(past_runs(desk.path(), 2).front().date, "2026-11-21 14:02:00 UTC");
}

TEST(History, ALineThatWasTornCostsNoOther) {
  const TemporaryFolder desk;
  remember(run_of(20, 1e-3), desk.path());
  std::ofstream(desk.path() / "history.jsonl", std::ios::app) << "{\"date\": \"2026-11-2";
  remember(run_of(22, 1e-3), desk.path());
  const auto runs = past_runs(desk.path());
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[1].date, "2026-11-22 14:02:00 UTC");
}

TEST(History, ATrendIsDrawnFromTwoRunsOn) {
  const TemporaryFolder desk;
  remember(run_of(20, 1e-3), desk.path());
  EXPECT_EQ(trend(past_runs(desk.path()), "pressure_l2", 0, "1"), "");
  remember(run_of(21, 2e-3), desk.path());
  const std::string line = trend(past_runs(desk.path()), "pressure_l2", 0, "1");
  EXPECT_THAT(line, HasSubstr("2026-11-20 14:02:00 UTC, 5e9c152d: 0.1\u00a0%\n2026-11-21"));
  // Tolerance 2e-3: the second run lies on the line of the tolerance, the first half way below it.
  EXPECT_THAT(line, HasSubstr("M73 12L80 6"));
  EXPECT_EQ(trend(past_runs(desk.path()), "no such quantity", 0, "1"), "");
}

TEST(History, WithoutADateNothingIsKept) {
  const TemporaryFolder desk;
  Record record = run_of(20, 1);
  record.provenance.erase("date");
  remember(record, desk.path());
  EXPECT_TRUE(past_runs(desk.path()).empty());
}

// The form is checked by a parser in page_test.py; here, what is said of each verdict.
TEST(Junit, SaysWhatFailedAndWhatIsOpen) {
  const TemporaryFolder desk;
  Record nothing;
  nothing.case_name = "nothing gated";
  write_result(testing::sample_record("column <1>"), desk.path() / "a");
  write_result(nothing, desk.path() / "b");
  write_junit({{"suite", {desk.path() / "a", desk.path() / "b"}}}, desk.path() / "junit.xml");
  const std::string xml = read_whole(desk.path() / "junit.xml");
  EXPECT_THAT(xml, HasSubstr("<testsuites name=\"wetfront\" tests=\"8\" failures=\"1\" errors=\"0\" skipped=\"2\""));
  EXPECT_THAT(xml, HasSubstr("<testsuite name=\"suite.column &lt;1&gt;\" tests=\"7\" failures=\"1\""));
  EXPECT_THAT(
      xml, HasSubstr("<failure message=\"error 0.412\u00a0kPa, tolerance 0.2\u00a0kPa, reference bound 0.01\u00a0kPa\">"
                     "Largest at z = 0.93 m, 1772 s, in the cell of the front.</failure>"));
  EXPECT_THAT(xml, HasSubstr("<skipped message=\"inconclusive: error 0.194\u00a0%, tolerance 0.2\u00a0%"));
  EXPECT_THAT(xml, HasSubstr("<skipped message=\"nothing is gated\"/>"));
  EXPECT_THAT(xml, Not(HasSubstr("mualem")));
}

}  // namespace
}  // namespace wetfront::reports
