#include "reports/write.h"
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
      write_result(record, runs.emplace_back(folder / name));
    }
    write_fields(testing::sample_fields(), runs.front());
    write_index(runs, folder / "index.html", "Seed column suite <everyday> & heavy");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
