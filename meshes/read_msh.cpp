#include "meshes/read_msh.h"

#include "meshes/msh_tokens.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace wetfront::meshes {
namespace {

/// What a gmsh element type number means here; absent: not an element we can use.
struct ElementShape {
  int dim, nodes;
};
std::optional<ElementShape> shape_of(long type) {
  switch (type) {
    case 15:
      return ElementShape{0, 1};
    case 1:
      return ElementShape{1, 2};
    case 3:
      return ElementShape{2, 4};
    case 5:
      return ElementShape{3, 8};
    default:
      return std::nullopt;
  }
}

struct Element {
  int dim;
  long physical;  ///< tag of its physical group; 0: none
  std::vector<long> nodes;
};

/// The file as it stands, before it becomes a mesh.
struct RawMesh {
  std::map<std::pair<int, long>, std::string> names;        ///< (dimension, physical tag) -> name
  std::map<std::pair<int, long>, long> physical_of_entity;  ///< (dimension, entity tag) -> physical tag
  std::map<long, Point> nodes;
  std::vector<Element> elements;
};

void read_names(Tokens& in, RawMesh& raw) {
  for (long left = in.count(); left > 0; --left) {
    const int dim = static_cast<int>(in.integer());
    const long tag = in.integer();
    raw.names[{dim, tag}] = in.quoted_word();
  }
}

void read_entities(Tokens& in, RawMesh& raw) {
  long counts[4];
  for (long& count : counts) count = in.count();
  for (int dim = 0; dim < 4; ++dim)
    for (long left = counts[dim]; left > 0; --left) {
      const long tag = in.integer();
      for (int i = 0; i < (dim == 0 ? 3 : 6); ++i) in.real();
      for (long physical = in.count(); physical > 0; --physical) {
        const long group = in.integer();
        raw.physical_of_entity.emplace(std::pair{dim, tag}, std::abs(group));
      }
      if (dim == 0) continue;
      for (long bounding = in.count(); bounding > 0; --bounding) in.integer();
    }
}

Point read_point(Tokens& in) {
  Point point;
  for (double& coordinate : point) coordinate = in.real();
  return point;
}

void read_nodes_4(Tokens& in, RawMesh& raw) {
  long blocks = in.count();
  for (int i = 0; i < 3; ++i) in.integer();  // number of nodes, smallest and largest tag
  for (; blocks > 0; --blocks) {
    in.integer(), in.integer();
    if (in.integer() != 0) throw in.error("parametric nodes cannot be read (only x y z). Save without them");
    std::vector<long> tags(in.count());
    for (long& tag : tags) tag = in.integer();
    for (long tag : tags) raw.nodes[tag] = read_point(in);
  }
}

ElementShape require_shape(Tokens& in, long type) {
  const auto shape = shape_of(type);
  if (!shape)
    throw in.error("elements of gmsh type " + std::to_string(type) +
                   " cannot be used (the solvers need lines, quadrilaterals or hexahedra of first order). " +
                   "Add 'Recombine Surface' to the geometry");
  return *shape;
}

void read_elements_4(Tokens& in, RawMesh& raw) {
  long blocks = in.count();
  for (int i = 0; i < 3; ++i) in.integer();
  for (; blocks > 0; --blocks) {
    const int dim = static_cast<int>(in.integer());
    const long entity = in.integer();
    const ElementShape shape = require_shape(in, in.integer());
    const auto physical = raw.physical_of_entity.find({dim, entity});
    for (long left = in.count(); left > 0; --left) {
      in.integer();
      Element element{shape.dim, physical == raw.physical_of_entity.end() ? 0 : physical->second, {}};
      for (int i = 0; i < shape.nodes; ++i) element.nodes.push_back(in.integer());
      raw.elements.push_back(std::move(element));
    }
  }
}

void read_nodes_2(Tokens& in, RawMesh& raw) {
  for (long left = in.count(); left > 0; --left) {
    const long tag = in.integer();
    raw.nodes[tag] = read_point(in);
  }
}

void read_elements_2(Tokens& in, RawMesh& raw) {
  for (long left = in.count(); left > 0; --left) {
    in.integer();
    const ElementShape shape = require_shape(in, in.integer());
    Element element{shape.dim, 0, {}};
    const long tags = in.count();
    for (long i = 0; i < tags; ++i) {
      const long tag = in.integer();
      if (i == 0) element.physical = tag;
    }
    for (int i = 0; i < shape.nodes; ++i) element.nodes.push_back(in.integer());
    raw.elements.push_back(std::move(element));
  }
}

RawMesh read_sections(Tokens& in) {
  RawMesh raw;
  bool version_4 = true;
  while (!in.at_end()) {
    const std::string section = in.word();
    if (section.size() < 2 || section[0] != '$')
      throw in.error("'" + section + "' opens no section (a gmsh mesh is made of $Sections). Is this a .msh file?");
    if (section == "$MeshFormat") {
      const std::string version = in.word();
      if (version != "4.1" && version != "2.2")
        throw in.error("format " + version + " cannot be read (4.1 and 2.2 can). Save with gmsh -format msh41");
      version_4 = version == "4.1";
      if (in.integer() != 0) throw in.error("a binary mesh cannot be read (only ASCII). Save with Mesh.Binary = 0");
    } else if (section == "$PhysicalNames") {
      read_names(in, raw);
    } else if (section == "$Entities") {
      read_entities(in, raw);
    } else if (section == "$Nodes") {
      version_4 ? read_nodes_4(in, raw) : read_nodes_2(in, raw);
    } else if (section == "$Elements") {
      version_4 ? read_elements_4(in, raw) : read_elements_2(in, raw);
    }
    in.skip_past("$End" + section.substr(1));
  }
  return raw;
}

/// Nodes used by cells, in the order of their tags; returns tag -> index.
std::map<long, int> take_nodes(const Tokens& in, const RawMesh& raw, Mesh& mesh) {
  std::set<long> used;
  for (const Element& element : raw.elements)
    if (element.dim == mesh.dim) used.insert(element.nodes.begin(), element.nodes.end());
  std::map<long, int> index;
  for (long tag : used) {
    const auto node = raw.nodes.find(tag);
    if (node == raw.nodes.end())
      throw in.error("a cell uses node " + std::to_string(tag) +
                     ", which the file does not list. Write the mesh again");
    index[tag] = static_cast<int>(mesh.nodes.size());
    mesh.nodes.push_back(node->second);
  }
  return index;
}

/// Position of `name` in a list of names, added when new.
int index_of(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  names.push_back(name);
  return static_cast<int>(names.size()) - 1;
}

void take_element(const Tokens& in, const RawMesh& raw, const Element& element, const std::map<long, int>& index,
                  Mesh& mesh) {
  const auto name = raw.names.find({element.dim, element.physical});
  if (element.dim == mesh.dim) {
    if (name == raw.names.end())
      throw in.error("a cell belongs to no named physical group (its soil would be unknown). " +
                     std::string("Add e.g. Physical Surface(\"soil\") = {...}"));
    for (long node : element.nodes) mesh.cells.push_back(index.at(node));
    mesh.region.push_back(index_of(mesh.region_names, name->second));
    return;
  }
  if (element.dim != mesh.dim - 1 || name == raw.names.end()) return;  // edges that are no side
  auto side = std::find_if(mesh.sides.begin(), mesh.sides.end(), [&](const Side& s) { return s.name == name->second; });
  if (side == mesh.sides.end()) side = mesh.sides.insert(side, Side{name->second, {}});
  for (long node : element.nodes) {
    const auto found = index.find(node);
    if (found == index.end())
      throw in.error("side '" + name->second + "' uses node " + std::to_string(node) + ", which belongs to no cell");
    side->faces.push_back(found->second);
  }
}

}  // namespace

Mesh read_msh(const std::filesystem::path& path) {
  Tokens in(path);
  const RawMesh raw = read_sections(in);
  Mesh mesh;
  mesh.dim = 0;
  for (const Element& element : raw.elements) mesh.dim = std::max(mesh.dim, element.dim);
  if (mesh.dim == 0)
    throw in.error("the mesh has no cells (no lines, quadrilaterals or hexahedra). Did you mesh the geometry?");
  const auto index = take_nodes(in, raw, mesh);
  for (const Element& element : raw.elements) take_element(in, raw, element, index, mesh);
  return mesh;
}

}  // namespace wetfront::meshes
