#include "verification/foreign/point_data.h"

#include "reports/whole_file.h"

#include <fmt/format.h>

#include <stdexcept>

namespace wetfront::verification {

void cannot_read(const std::string& name, const std::string& problem, const std::string& why,
                 const std::string& suggestion) {
  throw std::runtime_error(name + ": " + problem + " (" + why + "). " + suggestion);
}

void add_components(PointData& data, const std::string& name, const std::vector<double>& values,
                    std::size_t components) {
  const std::size_t points = values.size() / components;
  for (std::size_t c = 0; c < components; ++c) {
    std::vector<double> part(points);
    for (std::size_t i = 0; i < points; ++i) part[i] = values[i * components + c];
    data.scalars[components == 1 ? name : fmt::format("{}.{}", name, c)] = std::move(part);
  }
}

PointData read_points(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::string content = reports::read_whole(file);
  if (content.starts_with("\x89HDF")) return read_hdf5_points(file);
  if (content.starts_with("# vtk")) return read_legacy_vtk(content, name);
  if (content.find("<VTKFile") < 1000) return read_xml_vtk(content, name);
  if (file.extension() == ".csv" || file.extension() == ".txt") return read_csv_points(content, name);
  cannot_read(name, "its format is not known", "it begins neither as VTK nor as HDF5, and is not called .csv",
              "Write one of those.");
}

}  // namespace wetfront::verification
