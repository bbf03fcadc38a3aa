#include <shell_origami/contact/bounding_tree.h>

#include <algorithm>
#include <numeric>

namespace shell_origami {

BoundingTree::BoundingTree(const CollisionMesh& mesh) {
  std::vector<Vector3> centers;
  for (const CollisionMesh::Face& face : mesh.faces()) {
    const auto& [a, b, c] = face.vertices;
    const auto& rest = mesh.restPositions();
    centers.push_back((rest[a] + rest[b] + rest[c]) / 3);
  }
  std::vector<int> faces(centers.size());
  std::iota(faces.begin(), faces.end(), 0);
  nodes_.reserve(2 * faces.size());
  const std::vector<int>& first = mesh.firstFaces();
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    if (i > 0) body_roots_.push_back(static_cast<int>(nodes_.size()));
    if (first[i] < first[i + 1]) {
      divide(centers, faces.begin() + first[i], faces.begin() + first[i + 1]);
    }
  }
}

/// Adds the node of these faces and those below it, halved across the longer side of the centers'
/// box.
void BoundingTree::divide(const std::vector<Vector3>& centers, std::vector<int>::iterator begin,
                          std::vector<int>::iterator end) {
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  if (end - begin == 1) {
    nodes_[node].face = *begin;
    return;
  }
  Eigen::AlignedBox3d box;
  for (auto face = begin; face != end; ++face) box.extend(centers[*face]);
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [&](int f, int g) {
    return std::make_pair(centers[f][axis], f) < std::make_pair(centers[g][axis], g);
  });
  divide(centers, begin, middle);
  nodes_[node].second = static_cast<int>(nodes_.size());
  divide(centers, middle, end);
}

std::vector<BoundingTree::NodePair> BoundingTree::roots() const {
  if (body_roots_.empty()) return {{0, 0}};
  std::vector<NodePair> pairs;
  for (int root : body_roots_) pairs.push_back({0, root});
  return pairs;
}

std::vector<MovingBox> BoundingTree::boxesOfNodes(const std::vector<MovingBox>& faces) const {
  std::vector<MovingBox> boxes(nodes_.size());
  for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; --i) {
    if (nodes_[i].second < 0) {
      boxes[i] = faces[nodes_[i].face];
    } else {
      boxes[i] = boxes[i + 1];
      boxes[i].extend(boxes[nodes_[i].second]);
    }
  }
  return boxes;
}

}  // namespace shell_origami
