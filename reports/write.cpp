#include "reports/write.h"

#include "reports/escape.h"
#include "reports/field_picture.h"
#include "reports/figures.h"
#include "reports/film_page.h"
#include "reports/page.h"
#include "reports/record_json.h"
#include "reports/run_history.h"
#include "reports/whole_file.h"

#include <set>
#include <stdexcept>

namespace wetfront::reports {

namespace {

void check_pictures(const Record& record) {
  std::set<std::string> taken;
  for (const Figure& figure : record.figures) taken.insert(figure.id);
  for (const FieldPicture& picture : record.pictures) {
    check(picture);
    if (!taken.insert(picture.id).second)
      throw std::runtime_error("picture '" + picture.id + "': the id is used twice");
  }
  for (const Film& film : record.films)
    if (!is_stem(film.id) || !taken.insert(film.id + "_stills").second)
      throw std::runtime_error("film '" + film.id + "': the id is no file name stem, or used twice");
}

void render(const Record& record, const std::filesystem::path& folder) {
  check_pictures(record);
  const std::vector<DrawnFigure> drawn = write_figures(record.figures, folder / "figures");
  for (const FieldPicture& picture : record.pictures) write_picture(picture, folder / "figures");
  for (const Film& film : record.films) write_stills(film, folder / "figures");
  write_whole(folder / "report.html", report_page(record, drawn, past_runs(folder)));
}

}  // namespace

void make_writable(const std::filesystem::path& folder) {
  make_folder(folder);
  for (const auto& part : {folder, folder / "figures", folder / "fields"}) clear_half_written(part);
  const std::filesystem::path trial = folder / ".trial";
  write_whole(trial, "x");
  std::filesystem::remove(trial);
}

void write_result(const Record& record, const std::filesystem::path& folder) {
  make_folder(folder);
  // The data first: they outlive a drawing that fails.
  write_whole(folder / "result.json", to_json(record));
  remember(record, folder);
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
