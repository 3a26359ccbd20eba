#include "reports/record_json.h"
#include "reports/table_html.h"
#include "reports/whole_file.h"
#include "tests/reports/json_schema.h"
#include "tests/reports/sample_record.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace wetfront::reports {
namespace {

using ::testing::HasSubstr;
using testing::sample_record;

constexpr double inf = std::numeric_limits<double>::infinity();

/// Equal to the bit, NaN to NaN.
void expect_equal(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])));
}

void expect_equal(const Finding& a, const Finding& b) {
  EXPECT_EQ(a.quantity, b.quantity);
  EXPECT_EQ(a.description, b.description);
  EXPECT_EQ(a.group, b.group);
  EXPECT_EQ(a.unit, b.unit);
  expect_equal({a.error, a.reference_bound, a.tolerance, a.cpu_s}, {b.error, b.reference_bound, b.tolerance, b.cpu_s});
  EXPECT_EQ(a.reference_convergence, b.reference_convergence);
  expect_equal({a.reference_order}, {b.reference_order});
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.explanation, b.explanation);
}

void expect_equal(const Figure& a, const Figure& b) {
  EXPECT_EQ(std::tie(a.id, a.title, a.section, a.x_label, a.x_unit, a.y_label, a.y_unit, a.note, a.log_x, a.log_y),
            std::tie(b.id, b.title, b.section, b.x_label, b.x_unit, b.y_label, b.y_unit, b.note, b.log_x, b.log_y));
  ASSERT_EQ(a.shaded.size(), b.shaded.size());
  for (std::size_t i = 0; i < a.shaded.size(); ++i) {
    expect_equal({a.shaded[i].from, a.shaded[i].to}, {b.shaded[i].from, b.shaded[i].to});
    EXPECT_EQ(a.shaded[i].label, b.shaded[i].label);
  }
  ASSERT_EQ(a.series.size(), b.series.size());
  for (std::size_t i = 0; i < a.series.size(); ++i) {
    const Series &s = a.series[i], &t = b.series[i];
    EXPECT_EQ(std::tie(s.label, s.style, s.colour), std::tie(t.label, t.style, t.colour));
    expect_equal(s.x, t.x);
    expect_equal(s.y, t.y);
  }
}

void expect_equal(const Record& a, const Record& b) {
  EXPECT_EQ(std::tie(a.case_name, a.title, a.requirement, a.scene_path, a.scene_text, a.verdict, a.plan_text, a.log,
                     a.provenance, a.cpu_seconds),
            std::tie(b.case_name, b.title, b.requirement, b.scene_path, b.scene_text, b.verdict, b.plan_text, b.log,
                     b.provenance, b.cpu_seconds));
  ASSERT_EQ(a.findings.size(), b.findings.size());
  for (std::size_t i = 0; i < a.findings.size(); ++i) expect_equal(a.findings[i], b.findings[i]);
  ASSERT_EQ(a.figures.size(), b.figures.size());
  for (std::size_t i = 0; i < a.figures.size(); ++i) expect_equal(a.figures[i], b.figures[i]);
  ASSERT_EQ(a.tables.size(), b.tables.size());
  for (std::size_t i = 0; i < a.tables.size(); ++i)
    EXPECT_EQ(
        std::tie(a.tables[i].title, a.tables[i].section, a.tables[i].caption, a.tables[i].header, a.tables[i].rows),
        std::tie(b.tables[i].title, b.tables[i].section, b.tables[i].caption, b.tables[i].header, b.tables[i].rows));
}

nlohmann::json schema() {
  return nlohmann::json::parse(read_whole(std::string(WETFRONT_SOURCE_DIR) + "/reports/result.schema.json"));
}

TEST(RecordJson, ARecordSurvivesTheFile) {
  const Record record = sample_record();
  expect_equal(record, from_json(to_json(record)));
}

TEST(TableHtml, ALongTableOfTheAuditIsClosedUntilAskedFor) {
  Table table{"Rain over each node", "Flux audit", "", {"node"}, {}};
  table.rows.assign(24, {"1"});
  EXPECT_EQ(table_html(table, TableForm::whole).find("<details"), std::string::npos);
  table.rows.assign(25, {"1"});
  EXPECT_THAT(table_html(table, TableForm::whole),
              HasSubstr("<details class=\"folded\"><summary>Rain over each node, 25 rows</summary>"));
  table.section = "Cost";
  EXPECT_EQ(table_html(table, TableForm::whole).find("<details"), std::string::npos);
}

TEST(RecordJson, NumbersThatJsonLacksSurvive) {
  Record record = sample_record();
  record.findings[0].error = std::nan("");
  record.findings[1].error = inf;
  record.findings[2].error = -inf;
  record.figures[0].series[0].x[3] = inf;
  record.figures[0].shaded = {{-inf, 3, "until now"}};
  record.findings[3].error = std::numeric_limits<double>::denorm_min();
  record.findings[4].error = 0.1 + 0.2;
  const std::string text = to_json(record);
  EXPECT_THAT(text, HasSubstr("\"error\":\"NaN\""));
  EXPECT_THAT(text, HasSubstr("\"error\":\"-Infinity\""));
  expect_equal(record, from_json(text));
}

TEST(RecordJson, ConformsToItsSchema) {
  Record record = sample_record();
  record.findings[0].error = std::nan("");
  EXPECT_THAT(testing::violations(schema(), nlohmann::json::parse(to_json(record))), ::testing::IsEmpty());
  EXPECT_THAT(testing::violations(schema(), nlohmann::json::parse(to_json(Record{}))), ::testing::IsEmpty());
}

TEST(RecordJson, TheSchemaCanBeBroken) {
  nlohmann::json json = nlohmann::json::parse(to_json(sample_record()));
  json["findings"][1].erase("reason");
  json["findings"][2]["error"] = "none";
  json["surprise"] = 1;
  json["figures"][0]["id"] = "../x";
  EXPECT_EQ(testing::violations(schema(), json).size(), 4U);
}

TEST(RecordJson, ProvenanceIsAlwaysThere) {
  const Record read = from_json(to_json(Record{}));
  for (const char* key : {"git_hash", "dirty", "input_hash", "mesh_hash", "compiler", "isa", "threads", "cpu"})
    EXPECT_EQ(read.provenance.at(key), "unknown") << key;
}

TEST(RecordJson, BytesThatAreNoUtf8DoNotStopTheReport) {
  Record record = sample_record();
  record.log = {"broken \xff byte"};
  EXPECT_EQ(from_json(to_json(record)).log[0], "broken \xEF\xBF\xBD byte");
}

std::string message_of(const std::string& text) {
  try {
    from_json(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(RecordJson, RefusesWhatItCannotRead) {
  EXPECT_THAT(message_of("{"), HasSubstr("not a wetfront-result/1 file"));
  EXPECT_THAT(message_of("{\"schema\": \"wetfront-result/7\"}"), HasSubstr("its schema is 'wetfront-result/7'"));
  nlohmann::json json = nlohmann::json::parse(to_json(sample_record()));
  json["findings"][0].erase("tolerance");
  EXPECT_THAT(message_of(json.dump()), HasSubstr("tolerance"));
  json = nlohmann::json::parse(to_json(sample_record()));
  json["verdict"] = "maybe";
  EXPECT_THAT(message_of(json.dump()), HasSubstr("'maybe' is not a verdict"));
}

}  // namespace
}  // namespace wetfront::reports
