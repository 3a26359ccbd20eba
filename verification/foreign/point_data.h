#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include <filesystem>

/// Data at points as another code wrote them: names, units and signs are its own.
namespace wetfront::verification {

struct PointData {
  std::vector<std::array<double, 3>> position;
  std::map<std::string, std::vector<double>> scalars;  ///< one value per point; components of vectors as "name.0"
};

/// Legacy VTK, ASCII or binary (big-endian), unstructured grids and polydata; XML VTK (.vtu, .vtp; ASCII, or inline
/// base64 without compression); HDF5 as the CB-Geo family writes it (one compound table of points); CSV with a header.
/// The format is told from the content. Throws std::runtime_error `file: problem (why). suggestion`.
PointData read_points(const std::filesystem::path& file);

PointData read_legacy_vtk(const std::string& content, const std::string& name);
PointData read_xml_vtk(const std::string& content, const std::string& name);
PointData read_csv_points(const std::string& content, const std::string& name);
PointData read_hdf5_points(const std::filesystem::path& file);

/// A field of so many components per point, one scalar each: "name.0", "name.1"; "name" where there is one.
void add_components(PointData& data, const std::string& name, const std::vector<double>& values,
                    std::size_t components);

/// `name: problem (why). suggestion`, as an exception.
[[noreturn]] void cannot_read(const std::string& name, const std::string& problem, const std::string& why,
                              const std::string& suggestion);

}  // namespace wetfront::verification
