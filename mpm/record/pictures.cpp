#include "mpm/record/pictures.h"

#include "mpm/grid/column_vector.h"

namespace wetfront::mpm {

template <int dim>
meshes::Snapshot snapshot_of(const StagePlan<dim>& plan, double time) {
  meshes::Snapshot snapshot;
  snapshot.time = time;
  snapshot.stage = plan.stage.name;
  const auto& points = plan.fields.points;
  for (const Block& block : points.blocks())
    for (std::size_t p = block.first; p < block.first + block.count; ++p)
      snapshot.points.position.push_back(point_of<dim>(points.position(p)));
  plan.output(snapshot);
  return snapshot;
}

template <int dim>
Picture picture_of(const StagePlan<dim>& plan, double time, const std::string& of) {
  Picture picture{snapshot_of(plan, time), of, {}};
  const auto& points = plan.fields.points;
  const Column* began = points.columns.find_allocated("initial position");
  if (began == nullptr) return picture;
  for (const Block& block : points.blocks())
    for (std::size_t p = block.first; p < block.first + block.count; ++p) {
      Vector<dim> moved = points.position(p);
      for (int a = 0; a < dim; ++a) moved[a] -= (*began)[a][p];
      picture.displacement.push_back(point_of<dim>(moved));
    }
  return picture;
}

template meshes::Snapshot snapshot_of(const StagePlan<2>&, double);
template meshes::Snapshot snapshot_of(const StagePlan<3>&, double);
template Picture picture_of(const StagePlan<2>&, double, const std::string&);
template Picture picture_of(const StagePlan<3>&, double, const std::string&);

}  // namespace wetfront::mpm
