#include <shell_origami/rviz/plugin/crease_box.h>

#include <shell_origami/rviz/plugin/fold_messages.h>

#include <QHeaderView>
#include <QSlider>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>

namespace shell_origami {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr int kMostDegrees = 179;
constexpr int kRowHeight = 22;  // [pixel]
enum Column { kName, kAngle, kTarget, kMoment, kSlider, kColumns };

/// Returns a number with one decimal, and no sign before a zero.
QString decimalText(double value) {
  return QString::number(std::round(10 * value) / 10 + 0.0, 'f', 1);
}

QString degreesText(double angle) { return decimalText(angle / kDegree); }

}  // namespace

CreaseBox::CreaseBox(PanelDesk& desk) : desk_(desk), table_(new QTableWidget(0, kColumns)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(table_);
  table_->setObjectName("creases");
  table_->setHorizontalHeaderLabels({"Crease", "Angle", "Target", "mN", "Fold to"});
  table_->horizontalHeaderItem(kAngle)->setToolTip("Now [degrees], valley > 0");
  table_->horizontalHeaderItem(kTarget)->setToolTip("Where it is folding to [degrees]");
  table_->horizontalHeaderItem(kMoment)->setToolTip("Moment [mN m per m], towards a valley > 0");
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kRowHeight);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  for (int column : {kAngle, kTarget}) table_->setColumnWidth(column, 56);
  table_->setColumnWidth(kMoment, 44);
  table_->setColumnWidth(kName, 66);
  table_->horizontalHeader()->setMinimumSectionSize(40);
  table_->horizontalHeader()->setStretchLastSection(true);
}

void CreaseBox::makeRows() {
  sheets_ = desk_.link.sheets();
  const auto& creases = desk_.link.paper()->sheet().creases();
  table_->setRowCount(0);
  table_->setRowCount(static_cast<int>(creases.size()));
  sliders_.clear();
  for (int row = 0; row < table_->rowCount(); ++row) {
    for (int column = kName; column <= kMoment; ++column) {
      table_->setItem(row, column, new QTableWidgetItem);
    }
    table_->item(row, kName)->setText(QString::fromStdString(creases[row].name));
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setObjectName(QString("slider_%1").arg(row));
    slider->setRange(-kMostDegrees, kMostDegrees);
    connect(slider, &QSlider::sliderReleased, [this, row] { turn(row); });
    table_->setCellWidget(row, kSlider, slider);
    sliders_.push_back(slider);
  }
}

void CreaseBox::turn(int row) {
  if (!desk_.link.paper() || sheets_ != desk_.link.sheets()) return;
  const TurnCrease turn{row, sliders_[row]->value() * kDegree};
  desk_.ask<msg::Fold>("fold", foldRequest(turn, desk_.link.paper()->sheet()));
}

void CreaseBox::refresh() {
  if (!desk_.link.paper()) {
    table_->setRowCount(0);
    sliders_.clear();
    return;
  }
  if (sheets_ != desk_.link.sheets()) makeRows();
  const auto& states = desk_.link.state().creases;
  if (states.size() != sliders_.size()) return;  // of another sheet
  for (std::size_t i = 0; i < states.size(); ++i) {
    const int row = static_cast<int>(i);
    QSlider& slider = *sliders_[i];
    const bool held = slider.isSliderDown();
    const double target = held ? slider.value() * kDegree : states[i].target_angle;
    table_->item(row, kAngle)->setText(degreesText(states[i].angle));
    table_->item(row, kTarget)->setText(degreesText(target));
    table_->item(row, kMoment)->setText(decimalText(1e3 * states[i].moment));
    if (!held) slider.setValue(static_cast<int>(std::lround(target / kDegree)));
  }
}

}  // namespace shell_origami
