#include "verification/foreign/point_data.h"

#include "reports/whole_file.h"

#include "verification/scene/complaints.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
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

const std::vector<double>& scalar(const PointData& data, const std::string& name, const std::filesystem::path& file) {
  const auto found = data.scalars.find(name);
  if (found != data.scalars.end()) return found->second;
  if (const auto text = data.no_numbers.find(name); text != data.no_numbers.end())
    throw std::runtime_error(text->second + " (column " + name +
                             " is compared). Write it with a point and without a unit.");
  std::vector<std::string> names;
  for (const auto& [other, values] : data.scalars) names.push_back(other);
  cannot_read(file.string(), "there is no array '" + name + "'", fmt::format("it has {}", fmt::join(names, ", ")),
              suggest(name, names));
}

PointData read_points(const std::filesystem::path& file, const PlaceNames& places) {
  const std::string name = file.string();
  const std::string content = reports::read_whole(file);
  if (content.starts_with("\x89HDF")) return read_hdf5_points(file, places);
  const bool vtk = content.starts_with("# vtk") || content.find("<VTKFile") < 1000;
  if (vtk && std::ranges::any_of(places, [](const std::string& one) { return !one.empty(); }))
    cannot_read(name, "[columns] names coordinates, but this is VTK", "its points stand in no columns",
                "Leave x, y and z out; unit may stay.");
  if (content.starts_with("# vtk")) return read_legacy_vtk(content, name);
  if (content.find("<VTKFile") < 1000) return read_xml_vtk(content, name);
  if (file.extension() == ".csv" || file.extension() == ".txt") return read_csv_points(content, name, places);
  cannot_read(name, "its format is not known", "it begins neither as VTK nor as HDF5, and is not called .csv",
              "Write one of those.");
}

}  // namespace wetfront::verification
