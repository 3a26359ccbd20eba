#pragma once

#include <memory>
#include <span>
#include <vector>

namespace wetfront::fem_reference {

/// How the ranks of one solve talk. Each rank owns part of the unknowns and keeps, behind its own, copies ("ghosts") of
/// those of its neighbours that its cells touch. A default-constructed one is a solve on one rank: nothing to do.
/// Every call but the questions is collective: all ranks make it, in the same order.
class Ranks {
 public:
  Ranks() = default;
  /// `id` [own + ghost]: numbers that name an unknown on every rank; a rank's own lie between those of the ranks before
  /// and after it. On all ranks of MPI_COMM_WORLD at once.
  Ranks(const std::vector<long long>& id, int own);

  int count() const;
  int rank() const;
  int own() const;  ///< of a solve on several ranks only
  int ghosts() const;
  /// Number over all ranks of a local unknown, the first rank's first; of a solve on several ranks only.
  const std::vector<int>& global() const;
  long total() const;  ///< unknowns of all ranks; of a solve on several ranks only

  /// Ghosts of values [own + ghost] from their owners.
  void refresh(std::span<double> values) const;
  double max(double value) const;
  bool any(bool value) const;
  double sum(double value) const;
  /// Adds up arrays of equal length, place by place; every rank has the result.
  void sum(std::span<double> values) const;
  /// Everyone's values behind one another, the first rank's first; every rank has the result.
  std::vector<double> gather(std::span<const double> values) const;

 private:
  struct Links;
  std::shared_ptr<Links> links_;
};

}  // namespace wetfront::fem_reference
