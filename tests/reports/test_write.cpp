#include "reports/whole_file.h"
#include "reports/write.h"
#include "tests/reports/sample_record.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <cstdlib>
#include <functional>
#include <regex>
#include <set>

namespace wetfront::reports {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

/// Every address a page names, in attributes or style, but for places on the page itself and data: URLs.
std::set<std::string> addresses(const std::string& page) {
  static const std::regex reference(
      R"re((?:src|href|action|data|poster|srcset)\s*=\s*["']([^"'#][^"']*)["']|url\(\s*["']?([^)#"']+)|@import\s+([^;]+))re");
  std::set<std::string> found;
  for (std::sregex_iterator at(page.begin(), page.end(), reference), end; at != end; ++at) {
    const std::string address = (*at)[1].str() + (*at)[2].str() + (*at)[3].str();
    if (address.rfind("data:", 0) != 0) found.insert(address);
  }
  return found;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

TEST(WriteResult, WritesWhatItPromises) {
  const TemporaryFolder desk;
  const Record record = testing::sample_record();
  write_result(record, desk.path() / "new" / "run");
  for (const Figure& figure : record.figures)
    for (const char* kind : {".csv", ".gp", ".svg"})
      EXPECT_TRUE(fs::exists(desk.path() / "new/run/figures" / (figure.id + kind))) << figure.id << kind;
  EXPECT_TRUE(fs::exists(desk.path() / "new/run/result.json"));
  for (const auto& entry : fs::recursive_directory_iterator(desk.path()))
    EXPECT_THAT(entry.path().string(), Not(HasSubstr(".part")));
}

TEST(WriteResult, ThePageStandsAlone) {
  const TemporaryFolder desk;
  write_result(testing::sample_record(), desk.path());
  const std::string page = read_whole(desk.path() / "report.html");
  for (const std::string& address : addresses(page)) EXPECT_THAT(address, ::testing::StartsWith("figures/"));
  EXPECT_THAT(page, Not(HasSubstr("https://")));
  // The only "http://" is the name of the SVG language, with which the script makes elements.
  EXPECT_EQ(count_of(page, "http://"), count_of(page, "\"http://www.w3.org/2000/svg\""));
  EXPECT_LT(page.size(), 2'000'000U);
}

/// Below each drawing stand links to its data and to a vector file for papers, and every link leads to a file.
TEST(WriteResult, EveryDrawingLinksItsFiles) {
  const TemporaryFolder desk;
  const Record record = testing::sample_record();
  write_result(record, desk.path());
  const auto linked = addresses(read_whole(desk.path() / "report.html"));
  for (const std::string& address : linked) {
    EXPECT_TRUE(fs::is_regular_file(desk.path() / address)) << address;
    EXPECT_GT(fs::file_size(desk.path() / address), 50u) << address;
  }
  std::set<std::string> wanted;
  for (const Figure& figure : record.figures)
    for (const char* ending : {".csv", ".svg", ".gp"}) wanted.insert("figures/" + figure.id + ending);
  for (const FieldPicture& picture : record.pictures)
    for (const char* ending : {".csv", ".svg"}) wanted.insert("figures/" + picture.id + ending);
  for (const Film& film : record.films)
    for (const char* ending : {"_stills.csv", "_stills.svg"}) wanted.insert("figures/" + film.id + ending);
  EXPECT_EQ(linked, wanted);
  EXPECT_GE(record.pictures.size() * record.films.size(), 1u) << "the sample has drawings of all kinds";
}

TEST(WriteResult, SectionsWithoutContentAreNotThere) {
  const TemporaryFolder desk;
  Record record = testing::sample_record();
  write_result(record, desk.path());
  EXPECT_EQ(count_of(read_whole(desk.path() / "report.html"), "section-verdicts"), 2u)
      << "its heading and the way to it";
  record.findings.clear();
  std::erase_if(record.tables, [](const Table& table) { return table.section == "Verdicts"; });
  write_result(record, desk.path());
  EXPECT_EQ(count_of(read_whole(desk.path() / "report.html"), "section-verdicts"), 0u);
}

TEST(WriteResult, AddressesAreFound) {
  EXPECT_THAT(addresses("<img src='x.png'><a href=\"#top\"><style>a{b:url(f.woff)}</style><link href=\"data:,\">"),
              ::testing::ElementsAre("f.woff", "x.png"));
}

TEST(WriteResult, EveryTextIsEscaped) {
  Record record = testing::sample_record();
  const std::string evil = "<script>alert('x')</script>";
  record.title = record.case_name = record.requirement = record.plan_text = record.scene_text = record.scene_path =
      evil;
  record.log = {evil};
  record.provenance = {{evil, evil}, {"git_hash", evil}, {"date", evil}};
  for (Finding& finding : record.findings)
    finding.quantity = finding.description = finding.group = finding.unit = finding.reason = finding.explanation = evil;
  for (Figure& figure : record.figures) {
    figure.title = figure.section = figure.x_label = figure.y_label = figure.x_unit = figure.note = evil;
    figure.shaded = {{0, 1, evil}};
    for (Series& series : figure.series) series.label = evil;
  }
  for (Table& table : record.tables) {
    table.title = table.section = table.caption = evil;
    for (auto& cell : table.header) cell = evil;
    for (auto& row : table.rows)
      for (auto& cell : row) cell = evil;
  }
  const TemporaryFolder desk;
  write_result(record, desk.path());
  write_index({desk.path()}, desk.path() / "index.html", evil);
  EXPECT_EQ(count_of(read_whole(desk.path() / "report.html"), "<script>alert"), 0U);
  EXPECT_EQ(count_of(read_whole(desk.path() / "index.html"), "<script>alert"), 0U);
  EXPECT_GT(count_of(read_whole(desk.path() / "report.html"), "&lt;script&gt;alert"), 50U);
}

TEST(WriteResult, RenderingAgainGivesTheSamePage) {
  const TemporaryFolder desk;
  write_result(testing::sample_record(), desk.path());
  const std::string page = read_whole(desk.path() / "report.html");
  fs::remove(desk.path() / "report.html");
  fs::remove_all(desk.path() / "figures");
  render_again(desk.path());
  EXPECT_EQ(read_whole(desk.path() / "report.html"), page);
}

TEST(WriteResult, AnEmptyRecordIsStillAPage) {
  const TemporaryFolder desk;
  Record record;
  record.figures.resize(1);
  record.figures[0].id = "nothing";
  record.figures[0].series = {{"gone", Series::Style::line, {1}, {std::nan("")}, -1}};
  record.figures[0].log_x = true;
  write_result(record, desk.path());
  EXPECT_THAT(read_whole(desk.path() / "report.html"), HasSubstr("1 value not drawn"));
}

TEST(WriteResult, NamesTheFileThatCannotBeWritten) {
  const TemporaryFolder desk;
  // A folder where the page should be: fails for every user, root too.
  fs::create_directories(desk.path() / "report.html");
  EXPECT_THAT(message_of([&] { write_result(testing::sample_record(), desk.path()); }),
              HasSubstr((desk.path() / "report.html").string() + ": cannot write (Is a directory)"));
  EXPECT_TRUE(fs::exists(desk.path() / "result.json"));
  // A file where the folder should be.
  write_whole(desk.path() / "taken", "");
  EXPECT_THAT(message_of([&] { write_result(testing::sample_record(), desk.path() / "taken" / "run"); }),
              HasSubstr((desk.path() / "taken" / "run").string() + ": cannot make the folder (Not a directory)"));
}

TEST(WriteResult, AFullDiskLeavesTheOldFile) {
  // Every write to /dev/full fails with ENOSPC, as on a full disk; the link stands where the temporary file will be.
  const TemporaryFolder desk;
  write_whole(desk.path() / "a", "old");
  fs::create_symlink("/dev/full", desk.path() / ("a.part" + std::to_string(::getpid())));
  EXPECT_THAT(message_of([&] { write_whole(desk.path() / "a", "new"); }),
              HasSubstr((desk.path() / "a").string() + ": cannot write (No space left on device)"));
  EXPECT_EQ(read_whole(desk.path() / "a"), "old");
}

TEST(WriteResult, WhatAKilledWriterLeftGoesWithTheNextRun) {
  const TemporaryFolder desk;
  fs::create_directories(desk.path() / "figures");
  const std::vector<std::string> left = {"result.json.part12", "figures/front.svg.part345"};
  const std::vector<std::string> own = {"a.part", "figures/b.party", "figures/c.part2.csv", "result.json"};
  for (const auto* files : {&left, &own})
    for (const std::string& file : *files) write_whole(desk.path() / file, "x");
  make_writable(desk.path());
  for (const std::string& file : left) EXPECT_FALSE(fs::exists(desk.path() / file)) << file;
  for (const std::string& file : own) EXPECT_TRUE(fs::exists(desk.path() / file)) << file;
}

TEST(WriteResult, RefusesFiguresItCannotName) {
  const TemporaryFolder desk;
  Record record;
  record.figures.resize(1);
  record.figures[0].id = "../outside";
  EXPECT_THAT(message_of([&] { write_result(record, desk.path()); }),
              HasSubstr("'../outside' is not a file name stem"));
  record.figures[0].id = "twice";
  record.figures.push_back(record.figures[0]);
  EXPECT_THAT(message_of([&] { write_result(record, desk.path()); }), HasSubstr("'twice' is used twice"));
  record.figures.resize(1);
  record.figures[0].series = {{"s", Series::Style::line, {1, 2}, {1}, -1}};
  EXPECT_THAT(message_of([&] { write_result(record, desk.path()); }), HasSubstr("'s' has 2 x and 1 y values"));
}

/// Sets a variable of the environment and puts the old value back.
class Environment {
 public:
  Environment(const char* name, const std::string& value) : name_(name), old_(std::getenv(name)) {
    ::setenv(name, value.c_str(), 1);
  }
  ~Environment() { ::setenv(name_, old_.c_str(), 1); }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  const char* name_;
  std::string old_;
};

TEST(WriteResult, SaysThatGnuplotIsMissingAndKeepsTheData) {
  const TemporaryFolder desk;
  const Environment path("PATH", desk.path().string());
  EXPECT_THAT(
      message_of([&] { write_result(testing::sample_record(), desk.path()); }),
      ::testing::AllOf(HasSubstr("gnuplot: cannot be started (No such file or directory"), HasSubstr("gnuplot-nox")));
  EXPECT_EQ(read_result(desk.path() / "result.json").findings.size(), 8U);
  EXPECT_TRUE(fs::exists(desk.path() / "figures" / "water_ledger.csv"));
}

TEST(WriteResult, RepeatsWhatAFailingGnuplotSaid) {
  const TemporaryFolder desk;
  write_whole(desk.path() / "gnuplot", "#!/bin/sh\necho no luck today >&2\nexit 3\n");
  ::chmod((desk.path() / "gnuplot").c_str(), 0755);
  const Environment path("PATH", desk.path().string() + ":" + std::getenv("PATH"));
  EXPECT_THAT(message_of([&] { write_result(testing::sample_record(), desk.path() / "run"); }),
              HasSubstr("no luck today"));
}

TEST(ReadResult, NamesTheFile) {
  const TemporaryFolder desk;
  EXPECT_THAT(message_of([&] { render_again(desk.path()); }),
              HasSubstr((desk.path() / "result.json").string() + ": cannot read (No such file or directory)"));
  write_whole(desk.path() / "result.json", "{}");
  EXPECT_THAT(message_of([&] { render_again(desk.path()); }), HasSubstr((desk.path() / "result.json").string()));
}

TEST(WriteIndex, LinksAreRelativeAndLead) {
  const TemporaryFolder desk;
  std::vector<fs::path> runs;
  for (const char* name : {"a", "b & ü"})
    write_result(testing::sample_record(name), runs.emplace_back(desk.path() / name));
  write_index(runs, desk.path() / "pages" / "index.html", "Übersicht <&>");
  const std::string page = read_whole(desk.path() / "pages" / "index.html");
  std::set<std::string> pages, places;
  for (const std::string& address : addresses(page)) {
    pages.insert(address.substr(0, address.find('#')));
    if (address.find('#') != std::string::npos) places.insert(address.substr(address.find('#') + 1));
  }
  EXPECT_THAT(pages, ::testing::ElementsAre("../a/report.html", "../b%20%26%20%C3%BC/report.html"));
  // A cell leads to its quantity on the run's page.
  const std::string report = read_whole(desk.path() / "a" / "report.html");
  EXPECT_EQ(places.size(), 6U);
  for (const std::string& place : places) EXPECT_EQ(count_of(report, " id=\"" + place + "\""), 1U) << place;
  EXPECT_THAT(page, HasSubstr("<h1>Übersicht &lt;&amp;&gt;</h1>"));
  // One cell per gated quantity; two findings of one quantity share a cell, which shows the graver one.
  EXPECT_EQ(count_of(page, "worst of 2"), 2U);
  EXPECT_EQ(count_of(page, "<code>pressure_<wbr>l2</code>"), 1U);
  EXPECT_EQ(count_of(page, "mualem"), 0U);
}

/// What most runs gate stands first.
TEST(WriteIndex, WidelyGatedQuantitiesComeFirst) {
  const TemporaryFolder desk;
  const auto record = [](const std::vector<std::string>& gated) {
    Record out;
    for (const std::string& quantity : gated) {
      out.findings.emplace_back().quantity = quantity;
      out.findings.back().verdict = Verdict::pass;
    }
    out.findings.emplace_back().quantity = "told";  // decides nothing: no column
    return out;
  };
  write_result(record({"seldom", "often"}), desk.path() / "a");
  write_result(record({"often", "twice", "often"}), desk.path() / "b");
  write_result(record({"often", "twice"}), desk.path() / "c");
  write_index({desk.path() / "a", desk.path() / "b", desk.path() / "c"}, desk.path() / "index.html", "order");
  const std::string page = read_whole(desk.path() / "index.html");
  EXPECT_LT(page.find("<code>often</code>"), page.find("<code>twice</code>"));
  EXPECT_LT(page.find("<code>twice</code>"), page.find("<code>seldom</code>"));
  EXPECT_NE(page.find("<code>seldom</code>"), std::string::npos);
  EXPECT_EQ(page.find("<code>told</code>"), std::string::npos);
}

}  // namespace
}  // namespace wetfront::reports
