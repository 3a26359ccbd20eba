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
  std::map<std::string, std::string> no_numbers = {};  ///< columns that are no scalars: which cell of theirs says so
};

/// What tables call the coordinates x, y and z; empty: the format's own names.
using PlaceNames = std::array<std::string, 3>;

/// Legacy VTK, ASCII or binary (big-endian), unstructured grids and polydata; XML VTK (.vtu, .vtp; ASCII, or inline
/// base64 without compression); HDF5 as the CB-Geo family writes it (one compound table of points); CSV with a header,
/// cells parted by commas, semicolons or tabs. The format is told from the content. `places` are for CSV and HDF5
/// alone: VTK knows its points. Throws std::runtime_error `file: problem (why). suggestion`.
PointData read_points(const std::filesystem::path& file, const PlaceNames& places = {});

PointData read_legacy_vtk(const std::string& content, const std::string& name);
PointData read_xml_vtk(const std::string& content, const std::string& name);
/// Columns that hold anything but numbers are kept out (`no_numbers`), but for those of the coordinates.
PointData read_csv_points(const std::string& content, const std::string& name, const PlaceNames& places = {});
PointData read_hdf5_points(const std::filesystem::path& file, const PlaceNames& places = {});

/// The scalar of this name; throws where there is none, with what there is, or where its column holds no numbers.
const std::vector<double>& scalar(const PointData& data, const std::string& name, const std::filesystem::path& file);

/// A field of so many components per point, one scalar each: "name.0", "name.1"; "name" where there is one.
void add_components(PointData& data, const std::string& name, const std::vector<double>& values,
                    std::size_t components);

/// `name: problem (why). suggestion`, as an exception.
[[noreturn]] void cannot_read(const std::string& name, const std::string& problem, const std::string& why,
                              const std::string& suggestion);

}  // namespace wetfront::verification
