#pragma once

#include "verification/scene/section.h"

#include <filesystem>
#include <string>
#include <vector>

namespace wetfront::verification {

/// The rows of a table written in the scene or in a file, in SI; knows where each row stands.
class Rows {
 public:
  std::vector<std::vector<double>> column;  ///< as the key's columns; empty: nothing was given, or nothing sound
  std::size_t size() const { return column.empty() ? 0 : column.front().size(); }
  /// Complains where the row stands.
  void complain(std::size_t row, const Complaint& complaint);

 private:
  friend Rows read_pairs(SectionReader& reader, const std::string& name, const std::filesystem::path& folder);
  friend Rows read_vectors(SectionReader& reader, const std::string& name, const std::filesystem::path& folder);
  friend Rows read_record(SectionReader& reader, const std::string& name, const std::filesystem::path& folder);
  Complaints* complaints_ = nullptr;
  std::vector<Place> place_;  ///< in the scene
  std::string file_;          ///< "" where the rows stand in the scene
  std::vector<int> line_;     ///< in the file
};

/// A key that takes pairs: a list of rows, or the name of a CSV file beside the scene.
Rows read_pairs(SectionReader& reader, const std::string& name, const std::filesystem::path& folder);

/// A key that takes a record: one quantity, which becomes a row at time 0, or pairs [time, quantity]. Values are held
/// to the key's range, times ascend from 0 on.
Rows read_record(SectionReader& reader, const std::string& name, const std::filesystem::path& folder);

/// A key that takes a vector in the plane, which becomes a row at time 0, or rows [time, x, y]: columns time, x, y.
/// Values are held to the key's range, times start at 0 or later.
Rows read_vectors(SectionReader& reader, const std::string& name, const std::filesystem::path& folder);

/// Whether rows are written, a list or the name of a CSV file, where one quantity would do as well.
bool takes_rows(SectionReader& reader, const std::string& name);

/// Complains where column `c` falls from one row to the next, or (`strictly`) stays.
void check_ascending(Rows& rows, std::size_t c, bool strictly, const std::string& what);

}  // namespace wetfront::verification
