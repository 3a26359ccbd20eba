#include "verification/foreign/point_data.h"

#include <hdf5.h>

namespace wetfront::verification {
namespace {

/// A handle of the library, closed when it goes out of scope.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// The first data set of the file that is a table of compounds, at any depth.
std::string first_table(hid_t file) {
  std::string found;
  H5Ovisit(
      file, H5_INDEX_NAME, H5_ITER_NATIVE,
      [](hid_t root, const char* name, const H5O_info_t* info, void* out) -> herr_t {
        if (info->type != H5O_TYPE_DATASET) return 0;
        const Handle set(H5Dopen2(root, name, H5P_DEFAULT), H5Dclose);
        const Handle type(H5Dget_type(set), H5Tclose);
        if (H5Tget_class(type) != H5T_COMPOUND) return 0;
        *static_cast<std::string*>(out) = name;
        return 1;
      },
      &found);
  return found;
}

/// One member of the compound, converted to double by the library.
std::vector<double> column(hid_t set, const std::string& name, std::size_t rows) {
  const Handle type(H5Tcreate(H5T_COMPOUND, sizeof(double)), H5Tclose);
  H5Tinsert(type, name.c_str(), 0, H5T_NATIVE_DOUBLE);
  std::vector<double> values(rows);
  if (H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) values.clear();
  return values;
}

std::vector<std::string> number_members(hid_t type) {
  std::vector<std::string> names;
  for (int m = 0; m < H5Tget_nmembers(type); ++m) {
    const H5T_class_t kind = H5Tget_member_class(type, static_cast<unsigned>(m));
    if (kind != H5T_FLOAT && kind != H5T_INTEGER) continue;
    char* name = H5Tget_member_name(type, static_cast<unsigned>(m));
    names.push_back(name);
    H5free_memory(name);
  }
  return names;
}

}  // namespace

PointData read_hdf5_points(const std::filesystem::path& path, const PlaceNames& places) {
  const std::string name = path.string();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // what goes wrong is said here
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (file < 0)
    cannot_read(name, "it cannot be opened as HDF5", "it begins as such a file", "Is it written to its end?");
  const std::string table = first_table(file);
  if (table.empty())
    cannot_read(name, "there is no table of points in it",
                "a data set of compounds is meant, as the CB-Geo family writes it", "Write the points as one table.");
  const Handle set(H5Dopen2(file, table.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle type(H5Dget_type(set), H5Tclose), space(H5Dget_space(set), H5Sclose);
  const hssize_t rows = H5Sget_simple_extent_npoints(space);
  PointData data;
  for (const std::string& member : number_members(type)) {
    auto values = column(set, member, static_cast<std::size_t>(rows));
    if (values.empty())
      cannot_read(name, "the column " + member + " cannot be read", "the library refuses", "Is the file damaged?");
    data.scalars[member] = std::move(values);
  }
  data.position.resize(static_cast<std::size_t>(rows));
  const char* axes[] = {"coord_x", "coord_y", "coord_z"};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::string wanted = places[a].empty() ? axes[a] : places[a];
    const auto values = data.scalars.find(wanted);
    if (values == data.scalars.end()) {
      if (a == 2 && places[a].empty()) continue;
      cannot_read(name, "there is no column " + wanted, "it places the points",
                  "Write the points as the CB-Geo family does, or name the column in [columns].");
    }
    for (std::size_t i = 0; i < data.position.size(); ++i) data.position[i][a] = values->second[i];
  }
  return data;
}

}  // namespace wetfront::verification
