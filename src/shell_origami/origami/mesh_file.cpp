#include <shell_origami/origami/mesh_file.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <cstring>
#include <limits>
#include <locale>
#include <sstream>

namespace shell_origami {
namespace {

/// A stream that writes every bit of a double, with a point whatever the user's locale.
std::ostringstream exactStream() {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(std::numeric_limits<double>::max_digits10);
  return stream;
}

void writePoint(std::ostream& stream, const Positions& positions, Eigen::Index v) {
  stream << positions(0, v) << ' ' << positions(1, v) << ' ' << positions(2, v) << '\n';
}

void appendUint32(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<char>((value >> shift) & 0xff));
  }
}

void appendVector(std::string& bytes, const Vector3& vector) {
  for (int k = 0; k < 3; ++k) {
    const float value = static_cast<float>(vector[k]);
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    appendUint32(bytes, bits);
  }
}

}  // namespace

std::string objText(const Positions& positions, const std::vector<Triangle>& triangles) {
  std::ostringstream stream = exactStream();
  stream << "# shell_origami, metres\n";
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    stream << "v ";
    writePoint(stream, positions, v);
  }
  for (const auto& [a, b, c] : triangles) {
    stream << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
  return stream.str();
}

std::string stlText(const Positions& positions, const std::vector<Triangle>& triangles) {
  std::string bytes = "shell_origami, metres";  // must not begin with "solid"
  bytes.resize(80, ' ');
  appendUint32(bytes, static_cast<std::uint32_t>(triangles.size()));
  for (const auto& [a, b, c] : triangles) {
    const Vector3 p = positions.col(a), q = positions.col(b), r = positions.col(c);
    appendVector(bytes, (q - p).cross(r - p).normalized());
    for (const Vector3& corner : {p, q, r}) appendVector(bytes, corner);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string plyText(const Positions& positions, const std::vector<Triangle>& triangles) {
  std::ostringstream stream = exactStream();
  stream << "ply\nformat ascii 1.0\ncomment shell_origami, metres\n"
         << "element vertex " << positions.cols() << '\n'
         << "property double x\nproperty double y\nproperty double z\n"
         << "element face " << triangles.size() << '\n'
         << "property list uchar int vertex_indices\nend_header\n";
  for (Eigen::Index v = 0; v < positions.cols(); ++v) writePoint(stream, positions, v);
  for (const auto& [a, b, c] : triangles) stream << "3 " << a << ' ' << b << ' ' << c << '\n';
  return stream.str();
}

}  // namespace shell_origami
