#include <shell_origami/rviz/plugin/history_box.h>

#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>
#include <set>

namespace shell_origami {
namespace {

/// Edits that come between two looks. The list has no room for more.
constexpr std::uint32_t kQueue = HistoryBox::kMostRows;
constexpr int kNumber = Qt::UserRole;  ///< where an item keeps the number of its edit

/// \param since  when the first edit was of which the panel has heard
QString editText(const msg::Edit& edit, const ros::Time& since) {
  QString what = QString::fromStdString(edit.kind);
  if (edit.kind == msg::Edit::FOLD) {
    const std::string& name = edit.crease.empty() ? edit.name : edit.crease;
    if (!name.empty()) what += " " + QString::fromStdString(name);
    if (edit.part == 0) what += QString(", %1°").arg(edit.angle * 180 / M_PI, 0, 'f', 1);
  } else if (!edit.ids.empty()) {
    for (const std::string& id : edit.ids) what += " " + QString::fromStdString(id);
  } else if (edit.vertices.size() == 1) {
    what += QString(" vertex %1").arg(edit.vertices[0]);
  } else if (edit.vertices.size() > 1) {
    what += QString(", %1 vertices").arg(edit.vertices.size());
  } else if (!edit.path.empty()) {
    what += " " + QString::fromStdString(edit.path);
  }
  const double time = (edit.header.stamp - since).toSec();
  return QString("%1   +%2 s   %3").arg(edit.number).arg(time, 0, 'f', 1).arg(what);
}

}  // namespace

HistoryBox::HistoryBox(PanelDesk& desk)
    : desk_(desk),
      edit_topic_(desk.link, "edits", kQueue, [this](const msg::Edit& edit) { hear(edit); }),
      list_(new QListWidget),
      back_(new QPushButton("Go back to before it")) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(list_);
  layout->addWidget(back_);
  list_->setObjectName("edits");
  back_->setObjectName("go_back");
  back_->setToolTip("Undoes the selected edit and all after it");
  connect(back_, &QPushButton::clicked, [this] { goBack(); });
}

void HistoryBox::hear(const msg::Edit& edit) {
  // Frames move the paper all the time, and live parameters are none of its own.
  static const std::set<std::string> kNotUndone{msg::Edit::CARRY, msg::Edit::CONFIGURE};
  if (edit.kind == msg::Edit::PAPER) return list_->clear();
  if (edit.kind == msg::Edit::UNDO) return forget(edit.undone);
  if (kNotUndone.count(edit.kind) > 0) return;
  if (list_->count() == 0) since_ = edit.header.stamp;
  auto* item = new QListWidgetItem(editText(edit, since_), list_);
  item->setData(kNumber, QVariant::fromValue<qulonglong>(edit.number));
  if (list_->count() > kMostRows) delete list_->takeItem(0);
  list_->scrollToBottom();
}

void HistoryBox::forget(std::uint64_t from) {
  for (int row = list_->count() - 1; row >= 0; --row) {
    if (list_->item(row)->data(kNumber).toULongLong() >= from) delete list_->takeItem(row);
  }
}

void HistoryBox::goBack() {
  const QListWidgetItem* item = list_->currentItem();
  if (!item) return desk_.tell("No edit is selected.", true);
  msg::Undo::Request request;
  request.since = item->data(kNumber).toULongLong();
  desk_.ask<msg::Undo>("undo", request);
}

void HistoryBox::refresh() {
  if (desk_.link.node() != node_) list_->clear();
  node_ = desk_.link.node();
  edit_topic_.poll();
  back_->setEnabled(list_->currentItem() != nullptr);
}

}  // namespace shell_origami
