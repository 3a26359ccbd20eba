#pragma once

#include "verification/scene/complaints.h"
#include "verification/scene/keys.h"

#include <filesystem>
#include <string>
#include <vector>

namespace wetfront::verification {

/// What a file of numbers may hold.
struct CsvForm {
  std::string what;                               ///< "rain record"
  std::vector<std::vector<TableColumn>> headers;  ///< one of these
  std::string row;                                ///< an example of a row: "0, 100"
  std::string header = {};  ///< an example of a header; made from the first of `headers` when empty
};

/// The numbers of a file in SI, column by column.
struct CsvTable {
  std::size_t header = 0;  ///< which of the form's headers it has
  std::vector<std::vector<double>> column;
  std::vector<int> line;  ///< of each row in the file
  bool sound = false;     ///< false: complained of, only the sound rows are there

  std::size_t rows() const { return line.size(); }
};

/// Reads a file that starts with a header `name [unit], name [unit]`, lines of '#' left out. Complaints carry the
/// file's own lines and are sorted in where the scene names it. `unit_weight` [Pa/m] makes pressures of heads.
CsvTable read_csv(const std::filesystem::path& path, const CsvForm& form, double unit_weight, Place named_at,
                  Complaints& complaints);

}  // namespace wetfront::verification
