#include <shell_origami/origami/surface_file.h>

#include <shell_origami/base/error.h>
#include <shell_origami/base/files.h>

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

namespace shell_origami {
namespace {

constexpr std::uintmax_t kMostMeshBytes = std::uintmax_t{64} << 20;

/// Collects triangles, with one vertex for each place.
class SurfaceMaker {
 public:
  explicit SurfaceMaker(const Vector3& scale) : scale_(scale) {}

  void add(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 pose = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene.mMeshes[node.mMeshes[i]], pose);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(scene, *node.mChildren[i], pose);
  }

  Surface surface() const {
    Surface surface;
    surface.vertices.resize(3, static_cast<Eigen::Index>(numbers_.size()));
    for (const auto& [place, number] : numbers_) {
      surface.vertices.col(number) << place[0], place[1], place[2];
    }
    surface.faces = faces_;
    return surface;
  }

 private:
  void add(const aiMesh& mesh, const aiMatrix4x4& pose) {
    const bool mirrored = (scale_.prod() < 0) != (pose.Determinant() < 0);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices != 3) continue;
      Triangle corners{};
      for (int k = 0; k < 3; ++k) {
        const aiVector3D p = pose * mesh.mVertices[face.mIndices[k]];
        corners[mirrored ? 2 - k : k] = vertexAt(scale_.cwiseProduct(Vector3(p.x, p.y, p.z)));
      }
      const auto& [a, b, c] = corners;
      if (a != b && b != c && c != a) faces_.push_back(corners);
    }
  }

  int vertexAt(const Vector3& p) {
    return numbers_.emplace(std::array<double, 3>{p.x(), p.y(), p.z()}, numbers_.size())
        .first->second;
  }

  Vector3 scale_;
  std::map<std::array<double, 3>, int> numbers_;
  std::vector<Triangle> faces_;
};

}  // namespace

Surface readSurface(const std::string& path, const Vector3& scale) {
  static const std::set<std::string> kKinds{".stl", ".obj", ".dae"};
  std::string kind = std::filesystem::path(path).extension().string();
  for (char& c : kind) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (kKinds.count(kind) == 0) reject(path, ": a mesh is a .stl, .obj or .dae file");
  if (!scale.allFinite() || scale.prod() == 0) {
    reject(path, ": a scale of (", scale.x(), ", ", scale.y(), ", ", scale.z(), ")");
  }
  std::string bytes;
  try {
    bytes = readFile(path, kMostMeshBytes);
  } catch (const std::invalid_argument& error) {
    reject(path, ": ", error.what());
  }
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(),
                                                     aiProcess_Triangulate, kind.c_str() + 1);
  if (!scene || !scene->mRootNode) reject(path, ": ", importer.GetErrorString());
  SurfaceMaker maker(scale);
  maker.add(*scene, *scene->mRootNode, aiMatrix4x4());
  return maker.surface();
}

}  // namespace shell_origami
