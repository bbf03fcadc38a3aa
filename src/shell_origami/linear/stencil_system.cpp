#include <shell_origami/linear/stencil_system.h>

#include <utility>

namespace shell_origami {
namespace {

/// A pattern may be so many times larger than needed before it starts anew: each block more costs
/// time in every factorization, a new pattern an analysis, as much as some factorizations.
constexpr double kSpare = 1.3;

}  // namespace

void StencilSystem::setFree(const std::vector<bool>& free) {
  unknown_count_ = 0;
  numbers_.assign(free.size(), -1);
  for (std::size_t v = 0; v < free.size(); ++v) {
    if (free[v]) numbers_[v] = unknown_count_++;
  }
  graph_ = VertexGraph(unknown_count_);
  analyzed_ = false;
  targets_.clear();
}

bool StencilSystem::restorePattern(VertexGraph pattern) {
  if (!pattern.valid(unknown_count_)) return false;
  graph_ = std::move(pattern);
  analyzed_ = false;
  targets_.clear();
  return true;
}

bool StencilSystem::prepare(const std::vector<const Stencils*>& stencils) {
  bool known = analyzed_ && targets_.size() == stencils.size();
  for (std::size_t i = 0; known && i < stencils.size(); ++i) {
    known = targets_[i].found && targets_[i].revision == stencils[i]->revision();
  }
  if (known) return true;
  // A restored pattern is analyzed as it is: more would not be the one that it was taken of.
  if (!analyzed_ && !graph_.indices.empty() && !analyze(graph_)) return false;
  return (analyzed_ && findTargets(stencils)) || (grow(stencils) && findTargets(stencils));
}

/// Returns false where the matrix does not cover them.
bool StencilSystem::findTargets(const std::vector<const Stencils*>& stencils) {
  targets_.resize(stencils.size());
  for (std::size_t i = 0; i < stencils.size(); ++i) {
    List& list = targets_[i];
    if (list.found && list.revision == stencils[i]->revision()) continue;
    list.revision = stencils[i]->revision();
    list.found = list.targets.find(*stencils[i], rows_, matrix_);
    if (!list.found) return false;
  }
  return true;
}

bool StencilSystem::grow(const std::vector<const Stencils*>& stencils) {
  VertexGraph needed(unknown_count_), grown = graph_;
  needed.add(stencils, numbers_);
  grown.add(stencils, numbers_);
  const bool spare = grown.indices.size() > kSpare * static_cast<double>(needed.indices.size());
  return analyze(spare ? std::move(needed) : std::move(grown));
}

bool StencilSystem::analyze(VertexGraph graph) {
  analyzed_ = false;
  ++analyses_;
  const std::vector<int> order = eliminationOrder(graph);
  if (order.empty()) return false;
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<int>(i);
  rows_ = numbers_;
  for (int& row : rows_) {
    if (row >= 0) row = place[row];
  }
  matrix_ = BlockMatrix(graph.renumbered(place));
  targets_.clear();
  if (!cholesky_.analyze(matrix_)) return false;
  graph_ = std::move(graph);
  right_hand_side_.resize(matrix_.size());
  analyzed_ = true;
  return true;
}

void StencilSystem::addToDiagonal(double factor, const Eigen::VectorXd& weights) {
  for (std::size_t v = 0; v < rows_.size(); ++v) {
    if (rows_[v] >= 0) matrix_.addToDiagonal(rows_[v], factor * weights[v]);
  }
}

bool StencilSystem::solve(const Positions& gradient, Positions& step) {
  for (std::size_t v = 0; v < rows_.size(); ++v) {
    if (rows_[v] >= 0) right_hand_side_.segment<3>(3 * rows_[v]) = -gradient.col(v);
  }
  if (!cholesky_.solve(right_hand_side_)) return false;
  for (std::size_t v = 0; v < rows_.size(); ++v) {
    if (rows_[v] >= 0) step.col(v) = right_hand_side_.segment<3>(3 * rows_[v]);
  }
  return true;
}

}  // namespace shell_origami
