/// \file
/// The menu of the right mouse button on the paper.
#pragma once

#include <shell_origami/rviz/laid_fold.h>
#include <shell_origami/rviz/plugin/paper_link.h>

#include <boost/shared_ptr.hpp>

#include <functional>
#include <string>

class QMenu;

namespace shell_origami {

/// The actions of the menu's entries. The sheet may be another one by the time they run.
struct MenuActions {
  std::function<void(int vertex)> toggle_pin;
  std::function<void(const msg::Grasp::Request&)> grasp;
  std::function<void(const msg::Release::Request&)> release;
  std::function<void(const msg::AddVertex::Request&)> add_vertex;
  std::function<void(const msg::Fold::Request&)> fold;
  std::function<void(const std::string&)> name;  ///< the next fold
};

/// Returns what can be done at a spot. \pre the link has a paper
boost::shared_ptr<QMenu> foldMenu(const Spot& spot, const PaperLink& link,
                                  const MenuActions& actions);

}  // namespace shell_origami
