#pragma once

#include "fem_reference/discretisation.h"

#include <string>
#include <vector>

namespace wetfront::fem_reference {

/// A degree of freedom that can be held at a head, the water it gives up being an unknown.
struct HeldDof {
  enum class Kind { head, rain };
  int dof;
  Kind kind;
  int condition;    ///< index into RichardsProblem::boundary; its outflow goes there
  double head;      ///< the head it is held at (always for kind head; when ponded, 0, for kind rain) [m]
  double rain = 0;  ///< water offered by the rain now [m^dim/s]
  /// Share of each rain condition: {condition, horizontal area}. A corner may see two rain sides.
  std::vector<std::pair<int, double>> catchment;
};

/// The conditions of a problem on the degrees of freedom of its discretisation.
class Boundary {
 public:
  Boundary(const RichardsProblem& problem, const Discretisation& space);

  /// Takes the rain that falls just after `time`.
  void set_time(double time);
  /// Rain offered to one dof until `time` [m^dim].
  double asked(const HeldDof& held, double time) const;

  std::vector<HeldDof>& held() { return held_; }
  const std::vector<HeldDof>& held() const { return held_; }
  /// Free drainage: share with horizontal_area < 0 (facing down), and its condition.
  struct Drain {
    SideShare share;
    int condition;
  };
  const std::vector<Drain>& drains() const { return drains_; }
  int condition_count() const { return static_cast<int>(problem_.boundary.size()); }
  const std::string& side_name(int condition) const;
  /// Times in (0, end_time) at which some rain record changes, ascending, each once [s].
  std::vector<double> breaks() const;

 private:
  const meshes::RainRecord& record(int condition) const;

  const RichardsProblem& problem_;
  std::vector<HeldDof> held_;
  std::vector<Drain> drains_;
};

}  // namespace wetfront::fem_reference
