/// \file
/// The groups of vertices that an energy couples.
#pragma once

#include <cstdint>
#include <vector>

namespace shell_origami {

/// Small groups of vertices, one for each Hessian block of an energy: the corners of a triangle,
/// the four vertices of a hinge, the two ends of a spring.
class Stencils {
 public:
  int count() const { return static_cast<int>(starts_.size()) - 1; }
  /// The vertices of stencil i, in the order of its block's rows.
  const int* begin(int i) const { return vertices_.data() + starts_[i]; }
  const int* end(int i) const { return vertices_.data() + starts_[i + 1]; }

  /// Differs between any two lists of one energy that are not equal.
  std::uint64_t revision() const { return revision_; }

  /// Starts a list of another revision.
  void restart(std::uint64_t revision) {
    starts_.resize(1);
    vertices_.clear();
    revision_ = revision;
  }
  void add(const int* vertices, int count) {
    vertices_.insert(vertices_.end(), vertices, vertices + count);
    starts_.push_back(static_cast<int>(vertices_.size()));
  }

 private:
  std::vector<int> starts_{0}, vertices_;
  std::uint64_t revision_ = 0;
};

}  // namespace shell_origami
