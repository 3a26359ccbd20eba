#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <vector>

namespace wetfront::mpm {

/// Anderson's mixing (1965; type II, Walker & Ni 2011) of a fixed-point iteration y <- y + r(y). Of a linear iteration
/// it makes GMRES, so that a few slow modes cost a few passes and not their rate.
class Anderson {
 public:
  static constexpr std::size_t depth = 10;

  void clear() {
    changes_.clear();
    residual_changes_.clear();
    last_ = {};
  }

  /// The residual of the present y; returns what to add to y + r. `weight`: of the squares, per entry.
  std::vector<double> mix(const std::vector<double>& residual, const std::vector<double>& weight) {
    const auto size = static_cast<Eigen::Index>(residual.size());
    const Eigen::VectorXd r = Eigen::Map<const Eigen::VectorXd>(residual.data(), size);
    if (last_.size() == size) {
      changes_.push_back(last_step_);
      residual_changes_.push_back(r - last_);
      if (changes_.size() > depth) changes_.erase(changes_.begin()), residual_changes_.erase(residual_changes_.begin());
    }
    Eigen::VectorXd more = Eigen::VectorXd::Zero(size);
    if (!changes_.empty()) {
      const Eigen::VectorXd root = Eigen::Map<const Eigen::VectorXd>(weight.data(), size).cwiseSqrt();
      Eigen::MatrixXd d(size, static_cast<Eigen::Index>(changes_.size()));
      for (std::size_t k = 0; k < changes_.size(); ++k)
        d.col(static_cast<Eigen::Index>(k)) = root.cwiseProduct(residual_changes_[k]);
      Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(d);
      qr.setThreshold(1e-10);
      const Eigen::VectorXd share = qr.solve(root.cwiseProduct(r));
      for (std::size_t k = 0; k < changes_.size(); ++k)
        more -= share[static_cast<Eigen::Index>(k)] * (changes_[k] + residual_changes_[k]);
    }
    last_ = r;
    last_step_ = r + more;
    return {more.begin(), more.end()};
  }

 private:
  std::vector<Eigen::VectorXd> changes_, residual_changes_;
  Eigen::VectorXd last_, last_step_;
};

}  // namespace wetfront::mpm
