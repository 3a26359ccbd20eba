#pragma once

#include <string>
#include <vector>

namespace wetfront::reports {

/// What lies beside a page of one of its drawings: how the link reads, and how the file's name ends.
struct FigureFile {
  std::string name, ending;
};

/// Links from a page to the files of a drawing, `figures/<stem><ending>`, as a line below it.
std::string figure_files(const std::string& stem, const std::vector<FigureFile>& files);

}  // namespace wetfront::reports
