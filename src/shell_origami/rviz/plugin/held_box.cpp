#include <shell_origami/rviz/plugin/held_box.h>

#include <QGridLayout>
#include <QListWidget>
#include <QPushButton>

namespace shell_origami {
namespace {

QPushButton* button(const QString& text, const QString& name) {
  auto* made = new QPushButton(text);
  made->setObjectName(name);
  return made;
}

}  // namespace

HeldBox::HeldBox(PanelDesk& desk) : desk_(desk), list_(new QListWidget) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  list_->setObjectName("held");
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  grid->addWidget(list_, 0, 0, 1, 3);
  auto* selected = button("Unpin selected", "unpin_selected");
  auto* all = button("Unpin all", "unpin_all");
  auto* release = button("Release all", "release_all");
  connect(selected, &QPushButton::clicked, [this] { unpinSelected(); });
  connect(all, &QPushButton::clicked, [this] { desk_.ask<msg::Unpin>("unpin"); });
  connect(release, &QPushButton::clicked, [this] { desk_.ask<msg::Release>("release"); });
  grid->addWidget(selected, 1, 0);
  grid->addWidget(all, 1, 1);
  grid->addWidget(release, 1, 2);
}

void HeldBox::unpinSelected() {
  msg::Unpin::Request request;
  for (int row = 0; row < list_->count(); ++row) {
    const bool is_pin = row < static_cast<int>(pinned_.size());
    if (is_pin && list_->item(row)->isSelected()) request.vertices.push_back(pinned_[row]);
  }
  // An empty request would let go of all.
  if (request.vertices.empty()) return desk_.tell("No pin is selected.", true);
  desk_.ask<msg::Unpin>("unpin", request);
}

void HeldBox::refresh() {
  std::vector<std::uint32_t> pinned, grasped;
  if (desk_.link.paper()) {
    pinned = desk_.link.state().pinned;
    grasped = desk_.link.state().grasped;
  }
  if (pinned == pinned_ && grasped == grasped_) return;
  pinned_ = pinned;
  grasped_ = grasped;
  list_->clear();
  for (std::uint32_t vertex : pinned_) list_->addItem(QString("vertex %1, pinned").arg(vertex));
  for (std::uint32_t vertex : grasped_) list_->addItem(QString("vertex %1, grasped").arg(vertex));
}

}  // namespace shell_origami
