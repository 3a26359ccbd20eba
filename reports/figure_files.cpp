#include "reports/figure_files.h"

#include "reports/escape.h"

namespace wetfront::reports {

std::string figure_files(const std::string& stem, const std::vector<FigureFile>& files) {
  std::string out = "<p class=\"files\">";
  for (const FigureFile& file : files)
    out += (&file == &files.front() ? "" : " · ") + std::string("<a href=\"") +
           html(url_path("figures/" + stem + file.ending)) + "\">" + html(file.name) + "</a>";
  return out + "</p>";
}

}  // namespace wetfront::reports
