#include <shell_origami/origami/obstacles.h>

#include <shell_origami/base/error.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shell_origami {
namespace {

/// Sizes of obstacles [m]. Smaller than this, d^ would matter.
constexpr double kSmallest = 1e-3, kLargest = 100;
/// Factor by which obstacles slow down where a step fails, and below which they stop.
constexpr double kPaceCut = 0.25, kSlowestPace = 0.01;
/// A move that is late and makes less than this part of its way is stopped.
constexpr double kStoppedPace = 0.1;
/// Part of a step that is none: times are sums.
constexpr double kRoundedStep = 1e-6;

void checkSize(const char* what, double size) {
  if (!(size >= kSmallest && size <= kLargest)) {
    reject("an obstacle's ", what, " is ", size, " m, but must be from ", kSmallest, " to ",
           kLargest);
  }
}

struct CheckShape {
  void operator()(const HalfSpace&) const {}
  void operator()(const Box& box) const {
    for (int k = 0; k < 3; ++k) checkSize("box", box.size[k]);
  }
  void operator()(const Sphere& sphere) const { checkSize("radius", sphere.radius); }
  void operator()(const Cylinder& cylinder) const {
    checkSize("radius", cylinder.radius);
    checkSize("length", cylinder.length);
  }
  void operator()(const MeshShape& mesh) const {
    const Surface& surface = *mesh.surface;
    if (surface.faces.empty()) reject("an obstacle's mesh has no triangle");
    if (surface.vertices.cols() > kMostSurfaceParts ||
        static_cast<int>(surface.faces.size()) > kMostSurfaceParts) {
      reject("an obstacle's mesh has ", surface.vertices.cols(), " vertices and ",
             surface.faces.size(), " triangles, but may have ", kMostSurfaceParts);
    }
    if (!surface.vertices.allFinite()) reject("a coordinate of an obstacle's mesh is not finite");
    const Vector3 size =
        surface.vertices.rowwise().maxCoeff() - surface.vertices.rowwise().minCoeff();
    checkSize("mesh", size.maxCoeff());
    std::map<std::pair<int, int>, int> sides;  // how often they go one way less the other
    for (const Triangle& t : surface.faces) {
      for (int k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        if (a < 0 || a >= surface.vertices.cols()) reject("an obstacle's mesh has no vertex ", a);
        sides[std::minmax(a, b)] += a < b ? 1 : -1;
      }
    }
    for (const auto& [side, balance] : sides) {
      if (balance != 0) {
        reject("an obstacle's mesh is open at the edge of its vertices ", side.first, " and ",
               side.second);
      }
    }
  }
};

struct SameShape {
  bool operator()(const HalfSpace&, const HalfSpace&) const { return true; }
  bool operator()(const Box& a, const Box& b) const { return a.size == b.size; }
  bool operator()(const Sphere& a, const Sphere& b) const { return a.radius == b.radius; }
  bool operator()(const Cylinder& a, const Cylinder& b) const {
    return a.radius == b.radius && a.length == b.length;
  }
  bool operator()(const MeshShape& a, const MeshShape& b) const { return a.surface == b.surface; }
  template <class A, class B>
  bool operator()(const A&, const B&) const {
    return false;
  }
};

/// The surface from which on paper at `distance` is pushed.
struct MakeSurface {
  double distance;

  Surface operator()(const HalfSpace&) const { return planePatch(Vector3::Zero(), 1); }
  Surface operator()(const Box& box) const {
    return boxSurface(box.size - Vector3::Constant(2 * distance));
  }
  Surface operator()(const Sphere& sphere) const { return sphereSurface(sphere.radius - distance); }
  Surface operator()(const Cylinder& cylinder) const {
    return cylinderSurface(cylinder.radius - distance, cylinder.length - 2 * distance);
  }
  Surface operator()(const MeshShape&) const { return {}; }
};

}  // namespace

void checkShape(const ObstacleShape& shape) { std::visit(CheckShape{}, shape); }

Obstacles::Obstacles(std::map<std::string, Obstacle> all, double pace)
    : all_(std::move(all)), pace_(pace) {}

bool Obstacles::carriedBy(const std::string& frame) const {
  return std::any_of(all_.begin(), all_.end(),
                     [&](const auto& entry) { return entry.second.frame == frame; });
}

bool Obstacles::sameShapes(const Obstacles& others) const {
  return std::equal(all_.begin(), all_.end(), others.all_.begin(), others.all_.end(),
                    [](const auto& a, const auto& b) {
                      return a.first == b.first &&
                             std::visit(SameShape{}, a.second.shape, b.second.shape);
                    });
}

void Obstacles::carry(const std::string& frame, const Pose& pose) {
  for (auto& [id, obstacle] : all_) {
    if (obstacle.frame == frame) obstacle.next = pose;
  }
}

void Obstacles::move(const std::string& id, const Pose& target, double duration) {
  Obstacle& obstacle = all_.at(id);
  obstacle.target = target;
  obstacle.left = obstacle.due = duration;
}

void Obstacles::stop() {
  for (auto& [id, obstacle] : all_) {
    if (obstacle.left > 0) end(obstacle);
  }
}

void Obstacles::end(Obstacle& obstacle) {
  obstacle.left = obstacle.due = 0;
  obstacle.next = obstacle.base;
}

std::vector<Body> Obstacles::bodies(double distance) const {
  std::vector<Body> bodies;
  for (const auto& [id, obstacle] : all_) {
    const auto* mesh = std::get_if<MeshShape>(&obstacle.shape);
    bodies.push_back(
        {mesh ? mesh->surface
              : std::make_shared<const Surface>(std::visit(MakeSurface{distance}, obstacle.shape)),
         obstacle.friction});
  }
  return bodies;
}

Positions Obstacles::places(const std::vector<Body>& bodies, double distance, double s,
                            const Vector3& center, double size) const {
  Eigen::Index count = 0;
  for (const Body& body : bodies) count += body.surface->vertices.cols();
  Positions places(3, count);
  Eigen::Index column = 0;
  auto body = bodies.begin();
  for (const auto& [id, obstacle] : all_) {
    const Surface& surface = *(body++)->surface;
    const Pose pose = poseBetween(obstacle.base, obstacle.next, s) * obstacle.in_base;
    Positions local = surface.vertices;
    if (surface.half_space) {
      // About the same point of the plane all along the step.
      local = planePatch(obstacle.pose().fromWorld(center), size).vertices;
      local.row(2).setConstant(-distance);
    }
    for (Eigen::Index v = 0; v < local.cols(); ++v)
      places.col(column++) = pose.toWorld(local.col(v));
  }
  return places;
}

void Obstacles::aim(double time_step) {
  for (auto& [id, obstacle] : all_) {
    if (obstacle.left <= 0) continue;
    obstacle.next = (1 + kRoundedStep) * time_step >= obstacle.left
                        ? obstacle.target
                        : poseBetween(obstacle.base, obstacle.target, time_step / obstacle.left);
  }
}

bool Obstacles::moving() const {
  return std::any_of(all_.begin(), all_.end(), [](const auto& entry) {
    return entry.second.left > 0 || !(entry.second.base == entry.second.next);
  });
}

bool Obstacles::slowDown() {
  if (pace_ == 0 || !moving()) return false;
  pace_ *= kPaceCut;
  if (pace_ < kSlowestPace) pace_ = 0;
  return true;
}

void Obstacles::arrive(double time_step) {
  for (auto& [id, obstacle] : all_) {
    obstacle.base = poseBetween(obstacle.base, obstacle.next, pace_);
    if (obstacle.left <= 0) continue;
    obstacle.left -= pace_ * time_step;
    obstacle.due -= time_step;
    const double rounding = kRoundedStep * time_step;
    const bool stopped = obstacle.due < rounding && pace_ < kStoppedPace;
    if (obstacle.left < rounding || stopped) end(obstacle);
  }
  pace_ = std::min(1.0, std::max(2 * pace_, kSlowestPace));
}

}  // namespace shell_origami
