#include "reports/junit.h"
#include "reports/run_history.h"
#include "reports/write.h"
#include "tests/reports/sample_pictures.h"
#include "tests/reports/sample_record.h"

#include <cstdio>
#include <exception>
#include <filesystem>

/// Writes the sample report, three runs and their index into the folder given: for the page test and for the eye.
int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: reports_sample FOLDER\n");
    return 2;
  }
  try {
    using namespace wetfront::reports;
    const std::filesystem::path folder = arguments[1];
    std::vector<std::filesystem::path> runs;
    for (const char* name : {"seed_column", "deep column & Ton", "flume"}) {
      Record record = testing::sample_record(name);
      if (runs.size() == 1) {
        record.title = "Deep column, clay";
        record.findings.resize(2);
        record.verdict = Verdict::inconclusive;
        record.cpu_seconds = 312;
      }
      if (runs.size() == 2) {
        record.title = "Flume";
        record.findings.erase(record.findings.begin() + 1, record.findings.begin() + 3);
        record.verdict = Verdict::pass;
      }
      runs.push_back(folder / name);
      for (int earlier = 3; earlier >= 0; --earlier) {  // four runs of each, the last one as it stands
        Record run = record;
        run.provenance["date"] = "2026-11-" + std::to_string(22 - earlier) + " 14:02:00 UTC";
        for (Finding& finding : run.findings) finding.error *= 1 + 0.1 * earlier;
        if (earlier > 0)
          remember(run, runs.back());
        else
          write_result(run, runs.back());
      }
    }
    Record matrix = testing::sample_record("matrix");
    matrix.tables = {testing::sample_matrix()};
    matrix.figures.clear();
    matrix.pictures.clear();
    matrix.films.clear();
    write_result(matrix, runs.emplace_back(folder / "matrix"));
    Record large = testing::sample_record("large");  // outside the index: what a page of 100 000 points weighs
    large.title = "A slide of 100 000 points";
    large.films = {testing::sample_film(100000, 60)};
    write_result(large, folder / "large");
    write_fields(testing::sample_fields(), runs.front());
    write_index(runs, folder / "index.html", "Seed column suite <everyday> & heavy");
    write_junit({{"suite <&>", runs}}, folder / "junit.xml");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
