#include <shell_origami/contact/friction.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace shell_origami {
namespace {

using Map = Eigen::Matrix<double, 3, 12>;

Eigen::Matrix3d across(const Vector3& normal) {
  return Eigen::Matrix3d::Identity() - normal * normal.transpose();
}

/// Takes the displacements to that of x[to] - x[from].
Map difference(int from, int to) {
  Map map = Map::Zero();
  map.middleCols<3>(3 * from) = -Eigen::Matrix3d::Identity();
  map.middleCols<3>(3 * to) = Eigen::Matrix3d::Identity();
  return map;
}

}  // namespace

// The gap r = a e1 + b e2 + c n, by two edges of the pair and the normal n of both, turns to
//   r + a de1 + b de2 + c dn,   dn = -E (E^T E)^-1 (n . de1, n . de2),   E = (e1, e2).
FrictionPair frictionPair(const ContactPair& pair, const ClosestPoints& closest,
                          const PairPoints& x, double bound) {
  const bool face = pair.kind == PairKind::kVertexFace;
  const Map de1 = face ? difference(1, 2) : difference(0, 1);
  const Map de2 = face ? difference(1, 3) : difference(2, 3);
  Eigen::Matrix<double, 3, 2> e;
  e << (face ? x[2] - x[1] : x[1] - x[0]), (face ? x[3] - x[1] : x[3] - x[2]);
  const Vector3 n = e.col(0).cross(e.col(1)).normalized();
  const Eigen::Matrix2d metric = (e.transpose() * e).inverse();
  const Eigen::Vector2d along = metric * e.transpose() * closest.difference;
  Eigen::Matrix<double, 2, 12> tilt;
  tilt << n.transpose() * de1, n.transpose() * de2;
  Map map = -along[0] * de1 - along[1] * de2 + closest.difference.dot(n) * e * metric * tilt;
  for (int k = 0; k < 4; ++k) map.middleCols<3>(3 * k).diagonal().array() += closest.weights[k];
  const Vector3 normal = closest.direction();
  return {pair, across(normal) * map, normal, bound};
}

Vector3 slip(const FrictionPair& pair, const Positions& start, const Positions& x) {
  Eigen::Matrix<double, 12, 1> displacements;
  for (int k = 0; k < 4; ++k) {
    const int v = pair.pair.vertices[k];
    displacements.segment<3>(3 * k) = x.col(v) - start.col(v);
  }
  return pair.slip * displacements;
}

Derivatives smoothSlip(double slip, double sticking) {
  if (slip >= sticking) return {slip - sticking / 3, 1, 0};
  const double part = slip / sticking;
  return {slip * part * (1 - part / 3), part * (2 - part), 2 * (1 - part) / sticking};
}

Eigen::Matrix3d slipHessian(const Vector3& slip, const Vector3& normal, double sticking) {
  const double length = slip.norm();
  if (length == 0) return 2 / sticking * across(normal);
  const Derivatives f = smoothSlip(length, sticking);
  const Vector3 along = slip / length;
  return f.first / length * (across(normal) - along * along.transpose()) +
         f.second * along * along.transpose();
}

}  // namespace shell_origami
