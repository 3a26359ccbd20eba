#pragma once

#include <memory>
#include <span>
#include <string>
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
  int ghosts() const;
  /// Number over all ranks of a local unknown, the first rank's first; of a solve on several ranks only.
  const std::vector<int>& global() const;
  long total() const;  ///< unknowns of all ranks; of a solve on several ranks only

  /// Ghosts of values [own + ghost] from their owners.
  void refresh(std::span<double> values) const;
  /// Values of the own unknowns with their ghosts behind them.
  std::vector<double> with_ghosts(std::span<const double> own) const;
  bool any(bool value) const;
  /// The largest, place by place; every rank has the result. No value may be NaN.
  void max(std::span<double> values) const;
  double sum(double value) const;
  /// Adds up arrays of equal length, place by place; every rank has the result.
  void sum(std::span<double> values) const;
  /// Everyone's values behind one another, the first rank's first; every rank has the result.
  std::vector<double> gather(std::span<const double> values) const;
  /// The text of the rank with the largest weight (the lowest such rank), for all.
  std::string text_of_largest(double weight, std::string text) const;

 private:
  struct Links;
  std::shared_ptr<Links> links_;
};

}  // namespace wetfront::fem_reference
