#include <shell_origami/rviz/plugin/run_box.h>

#include <std_srvs/Trigger.h>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>

namespace shell_origami {
namespace {

constexpr int kMostSteps = 100000;

}  // namespace

RunBox::RunBox(PanelDesk& desk)
    : desk_(desk),
      energy_topic_(desk.link, "energy", 1, [this](const msg::Energy& e) { energy_ = e; }) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  const auto trigger = [&](int row, int column, const QString& text, const std::string& service,
                           const QString& tip) {
    addButton(*grid, row, column, text, tip,
              [this, service] { desk_.ask<std_srvs::Trigger>(service); });
  };
  trigger(0, 0, "Pause", "pause", "Stops simulated time");
  trigger(0, 1, "Resume", "resume", "Lets simulated time go on");
  trigger(1, 0, "Settle", "settle", "Moves the paper to equilibrium at once");
  addButton(*grid, 0, 2, "Step", "Takes so many steps, while paused", [this] {
    msg::Step::Request request;
    request.steps = static_cast<std::uint32_t>(steps_->value());
    desk_.ask<msg::Step>("step", request);
  });
  steps_ = new QSpinBox;
  steps_->setObjectName("steps");
  steps_->setRange(1, kMostSteps);
  steps_->setValue(10);
  grid->addWidget(steps_, 0, 3);
  addButton(*grid, 1, 1, "Undo", "Takes the last edit back",
            [this] { desk_.ask<msg::Undo>("undo"); });
  trigger(1, 2, "Reset", "reset", "The paper as it was loaded");
  addReading(*grid, 2, 0, "rest", rest_);
  addReading(*grid, 2, 2, "pace", pace_);
  addReading(*grid, 3, 0, "strain", strain_);
  addReading(*grid, 3, 2, "contacts", contacts_);
}

void RunBox::addButton(QGridLayout& grid, int row, int column, const QString& text,
                       const QString& tip, const std::function<void()>& pressed) {
  auto* button = new QPushButton(text);
  button->setObjectName(text.toLower());
  button->setToolTip(tip);
  connect(button, &QPushButton::clicked, pressed);
  grid.addWidget(button, row, column);
}

void RunBox::addReading(QGridLayout& grid, int row, int column, const QString& name,
                        QLabel*& reading) {
  reading = new QLabel;
  reading->setObjectName(name);
  grid.addWidget(reading, row, column, 1, 2);
}

void RunBox::refresh() {
  if (energy_topic_.poll()) energy_.reset();
  if (desk_.link.paper()) {
    const msg::SheetState& state = desk_.link.state();
    rest_->setText(QString(state.paused ? "paused" : state.settled ? "settled" : "moving"));
  } else {
    rest_->setText("no paper");
  }
  if (!energy_) {
    for (QLabel* reading : {pace_, strain_, contacts_}) reading->setText("");
    return;
  }
  pace_->setText(QString("real time x %1").arg(energy_->real_time_factor, 0, 'f', 2));
  strain_->setText(QString("strain %1 %").arg(100 * energy_->max_strain, 0, 'f', 4));
  contacts_->setText(QString("contacts %1").arg(energy_->contacts));
}

}  // namespace shell_origami
