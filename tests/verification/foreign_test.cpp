// Other codes' files: every format gives the same points; damaged ones are refused; signs and units that are declared
// wrongly are seen. The real file is Anura3D's (verification/cases/foreign_infiltration).
#include "verification/foreign/foreign_result.h"
#include "verification/foreign/point_data.h"
#include "verification/run/solve_reference.h"
#include "verification/scene/read.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <bit>
#include <fstream>

namespace wetfront::verification {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::filesystem::path real =
    std::filesystem::path(WETFRONT_SOURCE_DIR) / "verification/cases/foreign_infiltration";

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

template <class Number>
std::string big_endian(Number number) {
  std::string bytes(reinterpret_cast<const char*>(&number), sizeof number);
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

const std::string ascii_vtk =
    "# vtk DataFile Version 3.0\nthree points\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 2 float\n0 0.5 0\n0 1.5 0\n"
    "CELLS 2 4\n1 0\n1 1\nCELL_TYPES 2\n1\n1\nPOINT_DATA 2\nSCALARS p double 1\nLOOKUP_TABLE default\n-3\n4.5e0\n"
    "VECTORS v float\n1 2 3\n4 5 6\nCELL_DATA 2\nSCALARS q double\nLOOKUP_TABLE default\n7 8\n";

void expect_the_points(const PointData& data) {
  ASSERT_EQ(data.position.size(), 2u);
  EXPECT_DOUBLE_EQ(data.position[1][1], 1.5);
  EXPECT_THAT(data.scalars.at("p"), ElementsAre(-3, 4.5));
}

TEST(Foreign, LegacyVtkInAscii) {
  const PointData data = read_legacy_vtk(ascii_vtk, "a.vtk");
  expect_the_points(data);
  EXPECT_THAT(data.scalars.at("v.1"), ElementsAre(2, 5));
  EXPECT_FALSE(data.scalars.contains("q")) << "values of cells are not values of points";
}

TEST(Foreign, LegacyVtkInBinaryIsBigEndian) {
  std::string text = "# vtk DataFile Version 3.0\n\nBINARY\nDATASET POLYDATA\nPOINTS 2 double\n";
  for (const double x : {0.0, 0.5, 0.0, 0.0, 1.5, 0.0}) text += big_endian(x);
  text += "\nPOINT_DATA 2\nSCALARS id int 1\nLOOKUP_TABLE default\n" + big_endian(7) + big_endian(-8);
  text += "\nSCALARS p float 1\nLOOKUP_TABLE default\n" + big_endian(-3.0f) + big_endian(4.5f) + "\n";
  const PointData data = read_legacy_vtk(text, "b.vtk");
  expect_the_points(data);
  EXPECT_THAT(data.scalars.at("id"), ElementsAre(7, -8));
}

TEST(Foreign, XmlVtkInAsciiAndBase64) {
  const std::string head =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt32\">";
  const std::string points =
      "<Points><DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">0 0.5 0 0 1.5 "
      "0</DataArray></Points>";
  expect_the_points(read_xml_vtk(
      head + points +
          "<PointData><DataArray type=\"Float32\" Name=\"p\" format=\"ascii\">-3 4.5</DataArray></PointData></VTKFile>",
      "c.vtu"));
  // 8 bytes, then -3f and 4.5f: 08000000 000040c0 00009040
  expect_the_points(read_xml_vtk(head + points +
                                     "<PointData><DataArray type=\"Float32\" Name=\"p\" "
                                     "format=\"binary\">CAAAAAAAQMAAAJBA</DataArray></PointData></VTKFile>",
                                 "d.vtu"));
  EXPECT_THAT(refusal([&] {
                read_xml_vtk(head + points +
                                 "<PointData><DataArray type=\"Float32\" Name=\"p\" format=\"appended\" "
                                 "offset=\"0\"/></PointData></VTKFile>",
                             "e.vtu");
              }),
              HasSubstr("e.vtu: the array p is written in a way that is not read"));
}

TEST(Foreign, CsvWithColumns) {
  expect_the_points(read_csv_points("x,y,p\n0,0.5,-3\n0,1.5,4.5\n", "f.csv"));
  EXPECT_THAT(refusal([] { read_csv_points("x,y,p\n0,0.5\n", "f.csv"); }), HasSubstr("f.csv:2: this row has 2 cells"));
}

/// Whatever parts the cells; columns of text are left aside until somebody asks for them.
TEST(Foreign, CsvInItsDialects) {
  expect_the_points(read_csv_points("x;y;p\n0;0.5;-3\n0;1.5;4.5\n", "f.csv"));
  expect_the_points(read_csv_points("\xef\xbb\xbfx\ty\tp\r\n0\t0.5\t-3\r\n0\t1.5\t4.5\r\n", "f.csv"));
  const PointData named = read_csv_points("\"phase, state\",X,Height,p\n\"soil, wet\",0,0.5,-3\nsoil,0,1.5,4.5\n",
                                          "f.csv", {"X", "Height", ""});
  expect_the_points(named);
  EXPECT_EQ(named.scalars.size(), 1u);
  EXPECT_THAT(refusal([&] { scalar(named, "phase, state", "f.csv"); }),
              HasSubstr("f.csv:2: 'soil, wet' is no number (column phase, state is compared)"));
  EXPECT_THAT(refusal([&] { scalar(named, "q", "f.csv"); }), HasSubstr("f.csv: there is no array 'q' (it has p)"));
  const PointData late = read_csv_points("x,y,p\n0,0.5,-3\n0,1.5,\"3 kPa\"\n", "f.csv");
  EXPECT_THAT(refusal([&] { scalar(late, "p", "f.csv"); }), HasSubstr("f.csv:3: '3 kPa' is no number"));
  EXPECT_THAT(refusal([] { read_csv_points("x,y,p\n0,high,-3\n", "f.csv"); }), HasSubstr("column y holds places"));
  EXPECT_THAT(refusal([] { read_csv_points("a,b\n0,1\n", "f.csv"); }),
              HasSubstr("no column says where the points are"));
  EXPECT_THAT(refusal([] {
                read_csv_points("x,y,p\n0,1,2\n", "f.csv", {"", "Height", ""});
              }),
              HasSubstr("f.csv:1: there is no column 'Height'"));
}

TEST(Foreign, Hdf5AsTheCbGeoFamilyWritesIt) {
  struct Row {
    double x, y;
    float p;
    int status;
  };
  const Row rows[] = {{0, 0.5, -3, 1}, {0, 1.5, 4.5, 1}};
  const auto path = std::filesystem::path(testing::TempDir()) / "wetfront_points.h5";
  const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Row));
  H5Tinsert(type, "coord_x", HOFFSET(Row, x), H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "coord_y", HOFFSET(Row, y), H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "p", HOFFSET(Row, p), H5T_NATIVE_FLOAT);
  H5Tinsert(type, "status", HOFFSET(Row, status), H5T_NATIVE_INT);
  const hsize_t size = 2;
  const hid_t space = H5Screate_simple(1, &size, nullptr);
  const hid_t set = H5Dcreate2(file, "table", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, rows);
  H5Dclose(set), H5Sclose(space), H5Tclose(type), H5Fclose(file);
  expect_the_points(read_points(path));
  std::filesystem::resize_file(path, 900);
  EXPECT_THAT(refusal([&] { read_points(path); }), HasSubstr("cannot be opened as HDF5"));
  std::filesystem::remove(path);
}

/// Fifty of the ten thousand points that CB-Geo mpm itself wrote of a dry column: its own compound type, 53 members.
TEST(Foreign, ARealFileOfTheCbGeoFamily) {
  const auto path = std::filesystem::path(WETFRONT_SOURCE_DIR) / "tests/verification/data/cbgeo_50_points.h5";
  const PointData data = read_points(path);
  ASSERT_EQ(data.position.size(), 50u);
  EXPECT_DOUBLE_EQ(data.position[17][0], 0.025);
  EXPECT_DOUBLE_EQ(data.position[17][1], 0.36499952912);
  EXPECT_EQ(data.position[17][2], 0);
  EXPECT_EQ(data.scalars.at("pressure").size(), 50u);
  EXPECT_NEAR(data.scalars.at("volume")[34], 1e-4, 1e-15);
  EXPECT_EQ(data.scalars.at("id")[1] - data.scalars.at("id")[0], 200) << "every two hundredth was kept";
  EXPECT_THAT(refusal([&] { scalar(data, "presure", path); }), HasSubstr("Did you mean 'pressure'?"));
  EXPECT_EQ(read_points(path, {"coord_y", "coord_x", ""}).position[17][0], data.position[17][1]);
}

/// Cut anywhere, a file is refused or read as far as it is whole; it never crashes and never invents a value.
TEST(Foreign, AFileThatEndsEarlyIsRefused) {
  for (std::size_t size = 0; size < ascii_vtk.size(); size += 7) {
    try {
      const PointData data = read_legacy_vtk(ascii_vtk.substr(0, size), "cut.vtk");
      EXPECT_EQ(data.position.size(), 2u);
    } catch (const std::exception& error) {
      EXPECT_THAT(error.what(), HasSubstr("cut.vtk: "));
    }
  }
}

struct Judged {
  meshes::FieldHistory candidate;
  std::string hint;
};
/// The real result with its declaration changed.
Judged judged_with(const std::string& what, const std::string& by) {
  static const Scene scene = read_scene(real / "scene.toml");
  static const Timeline times = timeline(scene);
  static const meshes::FieldHistory reference = solve_reference(scene, times, {}).history;
  ForeignResult result = read_foreign(real / "anura3d.result");
  if (what == "factor") result.pressure.factor *= std::stod(by);
  Judged out{foreign_history(result, scene, times), ""};
  out.hint = looks_wrong(out.candidate, reference);
  return out;
}

TEST(Foreign, TheRealResultIsReadWithItsSign) {
  const Judged judged = judged_with("", "");
  ASSERT_EQ(judged.candidate.snapshots.size(), 1u);
  const auto& pressure = judged.candidate.snapshots[0].cell_pressure;
  EXPECT_NEAR(pressure.front(), -245, 60) << "suction just above the water table, compression-positive";
  EXPECT_EQ(judged.hint, "");
  EXPECT_EQ(judged.candidate.ledger.size(), 2u);
}

TEST(Foreign, AFlippedSignOrAUnitOffIsSeen) {
  EXPECT_THAT(judged_with("factor", "-1").hint, HasSubstr("the sign of the pressure looks flipped"));
  EXPECT_THAT(judged_with("factor", "1e-3").hint, HasSubstr("a thousand times too small"));
  EXPECT_THAT(judged_with("factor", "1e3").hint, HasSubstr("a thousand times too large"));
}

TEST(Foreign, ADeclarationIsCheckedAsScenesAre) {
  const auto path = std::filesystem::path(testing::TempDir()) / "declared.toml";
  std::ofstream(path)
      << "title = \"t\"\ncode = \"c\"\n[[snapshot]]\nfile = \"a.vtk\"\ntime = \"3 kg\"\n[pressure]\narray = "
         "\"p\"\nunit = \"kPa\"\npositive = \"upwards\"\n[saturation]\narrray = \"S\"\n";
  const std::string text = refusal([&] { read_foreign(path); });
  EXPECT_THAT(text, HasSubstr("declared.toml:5:8: "));
  EXPECT_THAT(text, HasSubstr("positive = \"upwards\" is no sign"));
  EXPECT_THAT(text, HasSubstr("Did you mean 'array'?"));
  std::filesystem::remove(path);
}

/// What a code is known for needs no declaration; what was assumed is said.
TEST(Foreign, AKnownCodeStandsForItsNames) {
  const auto path = std::filesystem::path(testing::TempDir()) / "short.result";
  const std::string head = "title = \"t\"\n[[snapshot]]\nfile = \"a.vtk\"\ntime = \"3 s\"\n";
  const auto declared = [&](const std::string& text) {
    std::ofstream(path) << text;
    return read_foreign(path);
  };
  const ForeignResult whole = read_foreign(real / "anura3d.result"), anura = declared("code = \"Anura3D\"\n" + head);
  EXPECT_EQ(anura.pressure.array, whole.pressure.array);
  EXPECT_EQ(anura.pressure.factor, whole.pressure.factor);
  EXPECT_EQ(anura.saturation.array, whole.saturation.array);
  EXPECT_THAT(whole.assumed, testing::IsEmpty());
  EXPECT_THAT(anura.assumed,
              ElementsAre("assumed, as Anura3D has it: [pressure] array = \"pressure_liquid\"",
                          "assumed, as Anura3D has it: [pressure] unit = \"kPa\"",
                          "assumed, as Anura3D has it: [pressure] positive = \"tension\"",
                          "assumed, as Anura3D has it: [saturation] array = \"degree_saturation_liquid\""));
  const ForeignResult geo = declared("code = \"cb-geo mpm\"\n" + head + "[saturation]\narray = \"svars_3\"\n");
  EXPECT_EQ(geo.pressure.array, "pressure");
  EXPECT_EQ(geo.pressure.factor, 1);
  EXPECT_THAT(refusal([&] { declared("code = \"CB-Geo\"\n" + head); }), HasSubstr("there is no [saturation]"));
  EXPECT_THAT(refusal([&] { declared("code = \"mine\"\n" + head); }), HasSubstr("there is no [pressure]"));
  std::filesystem::remove(path);
}

/// The real result once more, through a CSV file with other names, millimetres and text between: the same numbers.
TEST(Foreign, AColumnMapLeadsToTheSameNumbers) {
  const auto folder = std::filesystem::path(testing::TempDir());
  for (const char* step : {"000001", "004347"}) {
    const PointData data = read_points(real / (std::string("InfiltrationTest1DColumn_MPScalar_001") + step + ".vtk"));
    std::ofstream csv(folder / (std::string("map_") + step + ".csv"));
    csv.precision(17);
    csv << "phase;Height;p_w;S_w\n";
    for (std::size_t i = 0; i < data.position.size(); ++i)
      csv << "water;" << 1e3 * data.position[i][1] << ';' << -data.scalars.at("pressure_liquid")[i] << ';'
          << data.scalars.at("degree_saturation_liquid")[i] << '\n';
  }
  std::ofstream(folder / "map.result")
      << "title = \"t\"\ncode = \"mine\"\n[[snapshot]]\nfile = \"map_000001.csv\"\ntime = \"0.69 ms\"\n"
         "[[snapshot]]\nfile = \"map_004347.csv\"\ntime = \"3 s\"\n[columns]\ny = \"Height\"\nunit = \"mm\"\n"
         "pressure = \"p_w\"\nsaturation = \"S_w\"\n[pressure]\nunit = \"kPa\"\npositive = \"compression\"\n";
  const Scene scene = read_scene(real / "scene.toml");
  const Timeline times = timeline(scene);
  const auto whole = foreign_history(read_foreign(real / "anura3d.result"), scene, times);
  const auto mapped = foreign_history(read_foreign(folder / "map.result"), scene, times);
  ASSERT_EQ(mapped.snapshots.size(), whole.snapshots.size());
  for (std::size_t c = 0; c < whole.mesh.cell_count(); ++c) {
    EXPECT_NEAR(mapped.snapshots[0].cell_pressure[c], whole.snapshots[0].cell_pressure[c], 1e-6);
    EXPECT_NEAR(mapped.snapshots[0].cell_saturation[c], whole.snapshots[0].cell_saturation[c], 1e-12);
  }
  std::ofstream(folder / "map.result", std::ios::app) << "array = \"p_w\"\n";
  EXPECT_THAT(refusal([&] { read_foreign(folder / "map.result"); }), HasSubstr("pressure is named twice"));
}

}  // namespace
}  // namespace wetfront::verification
