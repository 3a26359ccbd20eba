#pragma once

#include "fem_reference/space/discretisation.h"

#include <limits>
#include <string>
#include <vector>

namespace wetfront::fem_reference {

/// A degree of freedom that can be held at a head, the water it gives up being an unknown.
struct HeldDof {
  enum class Kind { head, rain };
  int dof;
  Kind kind;          ///< of a water level: head while under water, else rain
  int condition;      ///< index into RichardsProblem::boundary; its outflow goes there
  double head;        ///< the head it is held at (always for kind head; when ponded, 0, for kind rain) [m]
  double rain = 0;    ///< water offered by rain or inflow now [m^dim/s]
  double demand = 0;  ///< water demanded by evaporation or extraction now [m^dim/s]
  double lowest = -std::numeric_limits<double>::infinity();  ///< psi below which the demand gets nothing [m]
  double head_rate = 0;                                      ///< d(head)/dt, kind head [m/s]

  /// Share of each condition that brings or takes water: a corner may see two sides.
  struct Catchment {
    int condition;
    double area;                  ///< horizontal area; of a FluxSide area
    double rain = 0, demand = 0;  ///< its part of `rain` and `demand` of the dof [m^dim/s]
  };
  std::vector<Catchment> catchment;
  double offset = 0;                          ///< elevation to subtract from the record of `condition` [m]
  double asked = 0, demanded = 0, since = 0;  ///< offered and demanded until `since` [m^dim, s]
};

/// The conditions of a problem on the degrees of freedom of its discretisation.
class Boundary {
 public:
  Boundary(const RichardsProblem& problem, const Discretisation& space);

  /// Takes what holds just after `time`, one of 0 and breaks(): rain, demand, what is under water, the heads. Times
  /// must not fall: the water asked for is summed up here.
  void set_time(double time);
  /// Moves the heads to a time between the last set_time() and the next break.
  void set_stage_time(double time);
  /// Rain offered to, and evaporation demanded from, one dof until `time` [m^dim].
  double asked(const HeldDof& held, double time) const { return held.asked + held.rain * (time - held.since); }
  double demanded(const HeldDof& held, double time) const { return held.demanded + held.demand * (time - held.since); }

  const std::vector<HeldDof>& held() const { return held_; }
  /// Free drainage: water leaves at K(psi) times `area`, the projection of the face that T g sees.
  struct Drain {
    int dof;
    int soil;
    double area;  ///< [m^(dim-1)]
    int condition;
  };
  const std::vector<Drain>& drains() const { return drains_; }
  int condition_count() const { return static_cast<int>(problem_.boundary.size()); }
  const std::string& side_name(int condition) const;
  /// Times in (0, end_time) at which a record changes or a water level passes a node, ascending, each once [s].
  const std::vector<double>& breaks() const { return breaks_; }
  bool has_demand() const { return has_demand_; }
  /// Some heads follow a record or a function of time.
  bool heads_move() const { return any_moving_; }

 private:
  void add_drain(const SideShare& share, int condition);
  void add_head(const SideShare& share, int condition, const Discretisation& space);
  void add_level(const SideShare& share, int condition, const Discretisation& space);
  void add_catchment(const SideShare& share, int condition, double area);
  HeldDof& entry(int dof, int condition);
  void find_breaks(const Discretisation& space);
  double middle_after(double time) const;
  void follow_function(HeldDof& held, double time) const;

  const RichardsProblem& problem_;
  const Discretisation& space_;
  std::vector<HeldDof> held_;
  std::vector<int> index_;   ///< [dof] -> held or -1
  std::vector<int> moving_;  ///< held dofs whose head has a record or varies
  std::vector<Drain> drains_;
  std::vector<double> breaks_;
  /// The piece of a condition's record that holds now: value + slope (t - time).
  struct Piece {
    double time = 0, value = 0, slope = 0;
  };
  std::vector<Piece> piece_;  ///< per condition
  bool has_demand_ = false, any_moving_ = false;
};

}  // namespace wetfront::fem_reference
