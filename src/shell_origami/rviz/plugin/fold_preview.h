/// \file
/// A preview of the laid fold: the creases that it would make, by the node's answer.
#pragma once

#include <shell_origami/rviz/plugin/fold_drawing.h>
#include <shell_origami/rviz/plugin/fold_messages.h>
#include <shell_origami/rviz/plugin/paper_link.h>
#include <shell_origami/rviz/plugin/requests.h>

#include <optional>
#include <string>
#include <vector>

namespace shell_origami {

/// Asks the node by a dry run of ~fold_through for the creases of a fold, one request at a time:
/// while one is under way, the next is the last that was shown.
class FoldPreview {
 public:
  explicit FoldPreview(PaperLink& link) : link_(link) {}

  /// \param eye  in the paper's world frame [m]
  /// \pre the link has a paper
  void show(const LaidFold& fold, const Vector3& eye);
  void clear();
  void poll() { requests_.poll(); }
  void draw(FoldDrawing& drawing) const;
  /// How many creases the fold would make or turn; 0: the node has not said yet.
  std::size_t creases() const { return segments_.size(); }
  /// Whether the node would not fold so, and its message.
  bool refused() const { return refused_; }
  const std::string& message() const { return message_; }

 private:
  void ask();
  void hear(const msg::FoldThrough::Response& response);
  std::vector<DrawnLine> plainLine() const;

  PaperLink& link_;
  Requests requests_;
  std::optional<LaidFold> fold_;
  std::optional<SeenFold> seen_;
  bool front_ = true;  ///< whether the layer of its first point shows its front
  std::optional<msg::FoldThrough::Request> asked_;  ///< last
  std::vector<msg::FlatSegment> segments_;          ///< of the last answer
  std::string message_;
  bool refused_ = false;
};

}  // namespace shell_origami
