#include "reports/write.h"

#include "reports/figures.h"
#include "reports/page.h"
#include "reports/record_json.h"
#include "reports/whole_file.h"

#include <stdexcept>

namespace wetfront::reports {

namespace {

void render(const Record& record, const std::filesystem::path& folder) {
  const std::vector<DrawnFigure> drawn = write_figures(record.figures, folder / "figures");
  write_whole(folder / "report.html", report_page(record, drawn));
}

}  // namespace

void make_writable(const std::filesystem::path& folder) {
  make_folder(folder);
  const std::filesystem::path trial = folder / ".trial";
  write_whole(trial, "x");
  std::filesystem::remove(trial);
}

void write_result(const Record& record, const std::filesystem::path& folder) {
  make_folder(folder);
  // The data first: they outlive a drawing that fails.
  write_whole(folder / "result.json", to_json(record));
  render(record, folder);
}

void render_again(const std::filesystem::path& folder) {
  render(read_result(folder / "result.json"), folder);
}

Record read_result(const std::filesystem::path& result_json) {
  const std::string text = read_whole(result_json);
  try {
    return from_json(text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(result_json.string() + ": " + error.what());
  }
}

}  // namespace wetfront::reports
