#include "reports/base64.h"
#include "reports/escape.h"
#include "reports/number_text.h"
#include "reports/whole_file.h"
#include "reports/write.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <map>
#include <stdexcept>

// VTK's XML format for unstructured grids ("VTK File Formats", Kitware; version 1.0 with 64-bit headers): arrays are
// base64 of an 8-byte length followed by the raw little-endian values, inline.
namespace wetfront::reports {

namespace {

static_assert(std::endian::native == std::endian::little, "the files declare little-endian data");

template <class T>
std::string array(const std::string& type, const std::string& name, int components, const std::vector<T>& values) {
  const std::uint64_t length = values.size() * sizeof(T);
  std::vector<unsigned char> bytes(sizeof length + length);
  std::copy_n(reinterpret_cast<const unsigned char*>(&length), sizeof length, bytes.begin());
  if (length > 0)
    std::copy_n(reinterpret_cast<const unsigned char*>(values.data()), length, bytes.begin() + sizeof length);
  return "<DataArray type=\"" + type + "\" Name=\"" + html(name) + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"binary\">" + base64(bytes) + "</DataArray>\n";
}

[[noreturn]] void reject(const FieldFile& file, const std::string& problem) {
  throw std::runtime_error("field file '" + file.stem + "' at " + exact_text(file.time) + " s: " + problem);
}

struct Cells {
  std::vector<std::int64_t> nodes, offsets;
  std::vector<std::uint8_t> types;
};

/// VTK's cell types: vertex 1, line 3, quadrilateral 9, hexahedron 12. Its node order is gmsh's, the mesh's.
Cells cells_of(const FieldFile& file, std::size_t node_count) {
  const bool points = file.cells.empty();
  const std::size_t per_cell = points ? 1 : std::size_t{1} << file.dim;
  const std::size_t count = points ? node_count : file.cells.size() / per_cell;
  if (count * per_cell != (points ? node_count : file.cells.size()))
    reject(file, std::to_string(file.cells.size()) + " cell nodes are no multiple of " + std::to_string(per_cell));
  Cells cells;
  for (std::size_t i = 0; i < count * per_cell; ++i) {
    const std::int64_t node = points ? static_cast<std::int64_t>(i) : file.cells[i];
    if (node < 0 || node >= static_cast<std::int64_t>(node_count))
      reject(file, "cell node " + std::to_string(node) + " of " + std::to_string(node_count));
    cells.nodes.push_back(node);
  }
  for (std::size_t c = 1; c <= count; ++c) cells.offsets.push_back(static_cast<std::int64_t>(c * per_cell));
  cells.types.assign(count, points ? 1 : file.dim == 1 ? 3 : file.dim == 2 ? 9 : 12);
  return cells;
}

std::string field_arrays(const FieldFile& file, bool per_cell, std::size_t entities) {
  std::string text;
  for (const FieldFile::Field& field : file.fields) {
    if (field.per_cell != per_cell) continue;
    if (field.values.size() != entities * static_cast<std::size_t>(field.components))
      reject(file, "field '" + field.name + "' has " + std::to_string(field.values.size()) + " values, not " +
                       std::to_string(entities) + " x " + std::to_string(field.components));
    text += array("Float64", field.name, field.components, field.values);
  }
  return text;
}

std::string vtu(const FieldFile& file) {
  if (file.dim < 1 || file.dim > 3) reject(file, "dim is " + std::to_string(file.dim));
  if (file.nodes.size() % 3 != 0) reject(file, "nodes do not have 3 coordinates each");
  const std::size_t nodes = file.nodes.size() / 3;
  const Cells cells = cells_of(file, nodes);
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<UnstructuredGrid>\n<FieldData>\n" +
         std::string("<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">") +
         exact_text(file.time) + "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(nodes) +
         "\" NumberOfCells=\"" + std::to_string(cells.types.size()) + "\">\n<Points>\n" +
         array("Float64", "Points", 3, file.nodes) + "</Points>\n<Cells>\n" +
         array("Int64", "connectivity", 1, cells.nodes) + array("Int64", "offsets", 1, cells.offsets) +
         array("UInt8", "types", 1, cells.types) + "</Cells>\n<PointData>\n" + field_arrays(file, false, nodes) +
         "</PointData>\n<CellData>\n" + field_arrays(file, true, cells.types.size()) +
         "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace

void write_fields(const std::vector<FieldFile>& files, const std::filesystem::path& folder) {
  const std::filesystem::path fields = folder / "fields";
  make_folder(fields);
  std::map<std::string, std::string> collections;
  std::map<std::string, int> next;
  for (const FieldFile& file : files) {
    char index[16];
    std::snprintf(index, sizeof index, "_%04d", next[file.stem]++);
    const std::string name = file.stem + index + ".vtu";
    write_whole(fields / name, vtu(file));
    collections[file.stem] +=
        "<DataSet timestep=\"" + exact_text(file.time) + "\" part=\"0\" file=\"" + html(name) + "\"/>\n";
  }
  for (const auto& [stem, entries] : collections)
    write_whole(fields / (stem + ".pvd"),
                "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
                "<Collection>\n" +
                    entries + "</Collection>\n</VTKFile>\n");
}

}  // namespace wetfront::reports
