#include "verification/foreign/point_data.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace wetfront::verification {

void cannot_read(const std::string& name, const std::string& problem, const std::string& why,
                 const std::string& suggestion) {
  throw std::runtime_error(name + ": " + problem + " (" + why + "). " + suggestion);
}

PointData read_points(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    cannot_read(name, "it cannot be read", "there is no such file, or permission is denied", "Check the path.");
  const std::string content((std::istreambuf_iterator<char>(in)), {});
  if (content.starts_with("\x89HDF")) return read_hdf5_points(file);
  if (content.starts_with("# vtk")) return read_legacy_vtk(content, name);
  if (content.find("<VTKFile") < 1000) return read_xml_vtk(content, name);
  if (file.extension() == ".csv" || file.extension() == ".txt") return read_csv_points(content, name);
  cannot_read(name, "its format is not known", "it begins neither as VTK nor as HDF5, and is not called .csv",
              "Write one of those.");
}

}  // namespace wetfront::verification
