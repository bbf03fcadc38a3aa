#include <shell_origami/sheet/vertex_grid.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace shell_origami {

VertexGrid::VertexGrid(const Sheet& sheet) : points_(sheet.flatPositions()) {
  Eigen::AlignedBox2d box;
  for (const Vector2& p : points_) box.extend(p);
  corner_ = box.min();
  const double count = static_cast<double>(points_.size());
  // Of a strip, too, no side has more cells than the sheet has vertices.
  size_ = std::max(std::sqrt(box.sizes().x() * box.sizes().y() / count),
                   box.sizes().maxCoeff() / count);
  columns_ = 1 + static_cast<int>(box.sizes().x() / size_);
  rows_ = 1 + static_cast<int>(box.sizes().y() / size_);
  const auto cell_of = [this](const Vector2& p) {
    return cell(p.y() - corner_.y(), rows_) * columns_ + cell(p.x() - corner_.x(), columns_);
  };
  firsts_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  for (const Vector2& p : points_) ++firsts_[cell_of(p) + 1];
  for (std::size_t i = 1; i < firsts_.size(); ++i) firsts_[i] += firsts_[i - 1];
  vertices_.resize(points_.size());
  std::vector<int> next(firsts_.begin(), firsts_.end() - 1);
  for (std::size_t v = 0; v < points_.size(); ++v) {
    vertices_[next[cell_of(points_[v])]++] = static_cast<int>(v);
  }
}

int VertexGrid::cell(double offset, int count) const {
  return static_cast<int>(std::clamp(std::floor(offset / size_), 0.0, count - 1.0));
}

int VertexGrid::nearest(const Vector2& p) const {
  const int column = cell(p.x() - corner_.x(), columns_), row = cell(p.y() - corner_.y(), rows_);
  std::pair<double, int> best{std::numeric_limits<double>::infinity(), 0};
  const auto search = [&](int r, int c) {
    if (r < 0 || r >= rows_ || c < 0 || c >= columns_) return;
    const int at = r * columns_ + c;
    for (int i = firsts_[at]; i < firsts_[at + 1]; ++i) {
      best = std::min(best, {(points_[vertices_[i]] - p).squaredNorm(), vertices_[i]});
    }
  };
  // Rings of cells around p's. Seen from the place of the grid nearest to p, and from p even more,
  // a vertex outside ring n is farther than n cells.
  for (int ring = 0; ring <= std::max(columns_, rows_); ++ring) {
    for (int c = column - ring; c <= column + ring; ++c) {
      search(row - ring, c);
      if (ring > 0) search(row + ring, c);
    }
    for (int r = row - ring + 1; r < row + ring; ++r) {
      search(r, column - ring);
      search(r, column + ring);
    }
    if (best.first < ring * size_ * ring * size_ * (1 - 1e-9)) break;
  }
  return best.second;
}

}  // namespace shell_origami
