#include <shell_origami/rviz/plugin/fold_menu.h>

#include <shell_origami/rviz/plugin/fold_messages.h>

#include <QInputDialog>
#include <QMenu>

#include <boost/make_shared.hpp>

namespace shell_origami {
namespace {

/// The name of a grasp that is made here.
std::string graspName(int vertex) { return "mouse_" + std::to_string(vertex); }

template <class Action>
void add(QMenu& menu, const QString& name, const QString& text, Action action) {
  QAction* entry = menu.addAction(text);
  entry->setObjectName(name);
  QObject::connect(entry, &QAction::triggered, action);
}

void addHolding(QMenu& menu, int vertex, const PaperLink& link, const MenuActions& actions) {
  const QString number = QString::number(vertex);
  add(menu, "pin", (link.isPinned(vertex) ? "Unpin vertex " : "Pin vertex ") + number,
      [=] { actions.toggle_pin(vertex); });
  if (link.isGrasped(vertex)) {
    msg::Release::Request request;
    request.ids = {graspName(vertex)};
    add(menu, "release", "Release vertex " + number, [=] { actions.release(request); });
  } else {
    msg::Grasp::Request request;
    request.id = graspName(vertex);
    request.vertices = {static_cast<std::uint32_t>(vertex)};
    add(menu, "grasp", "Grasp vertex " + number, [=] { actions.grasp(request); });
  }
}

void addCrease(QMenu& menu, int crease, const ShownPaper& paper, const MenuActions& actions) {
  const QString name = QString::fromStdString(paper.sheet().creases()[crease].name);
  const msg::Fold::Request unfold = foldRequest(TurnCrease{crease, 0}, paper.sheet());
  const msg::Fold::Request reverse =
      foldRequest(TurnCrease{crease, -paper.creaseAngle(crease)}, paper.sheet());
  menu.addSeparator();
  add(menu, "unfold", "Unfold crease " + name, [=] { actions.fold(unfold); });
  add(menu, "reverse", "Reverse crease " + name, [=] { actions.fold(reverse); });
}

void askForName(const MenuActions& actions) {
  const QString name = QInputDialog::getText(nullptr, "Fold", "Name of the next fold's creases:");
  if (!name.isEmpty()) actions.name(name.toStdString());
}

}  // namespace

boost::shared_ptr<QMenu> foldMenu(const Spot& spot, const PaperLink& link,
                                  const MenuActions& actions) {
  const auto menu = boost::make_shared<QMenu>();
  menu->setObjectName("fold_menu");
  const msg::AddVertex::Request vertex = addVertexRequest(spot.place, link.paper()->sheet());
  addHolding(*menu, spot.vertex, link, actions);
  add(*menu, "add_vertex", "Add a vertex here", [=] { actions.add_vertex(vertex); });
  if (spot.crease >= 0) addCrease(*menu, spot.crease, *link.paper(), actions);
  menu->addSeparator();
  add(*menu, "name", "Name the next fold...", [=] { askForName(actions); });
  return menu;
}

}  // namespace shell_origami
