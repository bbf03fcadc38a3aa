#include <shell_origami/rviz/plugin/file_box.h>

#include <dynamic_reconfigure/Reconfigure.h>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <utility>

namespace shell_origami {
namespace {

constexpr const char* kColoring = "colouring";
/// Its values, as the reference lists them.
const std::vector<QString> kColorings{"paper", "strain", "curvature", "contact"};

/// Parameters that are true or false, with their texts.
const std::vector<std::pair<std::string, QString>> kSwitches{
    {"crease_labels", "names and angles of creases"},
    {"vertex_ids", "numbers of vertices"},
    {"contact_points", "where layers touch"}};

QPushButton* addButton(QGridLayout& grid, int row, int column, const QString& text,
                       const QString& name) {
  auto* button = new QPushButton(text);
  button->setObjectName(name);
  grid.addWidget(button, row, column);
  return button;
}

}  // namespace

FileBox::FileBox(PanelDesk& desk)
    : desk_(desk),
      config_topic_(desk.link, "live/parameter_updates", 1, [this](const auto& m) { hear(m); }),
      path_(new QLineEdit),
      coloring_(new QComboBox) {
  auto* grid = new QGridLayout(this);
  addFile(*grid, 0);
  addDrawing(*grid, 3);
  grid->setRowStretch(8, 1);
}

void FileBox::addFile(QGridLayout& grid, int row) {
  path_->setObjectName("path");
  path_->setPlaceholderText(".fold .cp .opx .svg .yaml .obj .stl .ply");
  path_->setToolTip("A path on the node's machine");
  grid.addWidget(new QLabel("File"), row, 0);
  grid.addWidget(path_, row, 1, 1, 2);
  connect(addButton(grid, row + 1, 0, "Browse...", "browse"), &QPushButton::clicked,
          [this] { browse(); });
  connect(addButton(grid, row + 1, 1, "Load", "load"), &QPushButton::clicked, [this] { load(); });
  connect(addButton(grid, row + 1, 2, "Save", "save"), &QPushButton::clicked, [this] { save(); });
}

void FileBox::addDrawing(QGridLayout& grid, int row) {
  coloring_->setObjectName("coloring");
  for (const QString& name : kColorings) coloring_->addItem(name);
  grid.addWidget(new QLabel("Colors"), row, 0);
  grid.addWidget(coloring_, row, 1, 1, 2);
  // activated: chosen by a person, not by hear().
  connect(coloring_, QOverload<int>::of(&QComboBox::activated), [this](int) {
    dynamic_reconfigure::Config config;
    config.strs.resize(1);
    config.strs[0].name = kColoring;
    config.strs[0].value = coloring_->currentText().toStdString();
    change(config);
  });
  for (const auto& [name, text] : kSwitches) {
    auto* box = new QCheckBox(text);
    box->setObjectName(QString::fromStdString(name));
    switches_[name] = box;
    grid.addWidget(box, ++row, 1, 1, 2);
    connect(box, &QCheckBox::clicked, [this, parameter = name](bool on) {
      dynamic_reconfigure::Config config;
      config.bools.resize(1);
      config.bools[0].name = parameter;
      config.bools[0].value = on;
      change(config);
    });
  }
}

void FileBox::browse() {
  const QString path = QFileDialog::getSaveFileName(
      this, "A paper, or where to save it", path_->text(),
      "Papers and recipes (*.fold *.cp *.opx *.svg *.yaml *.obj *.stl *.ply)", nullptr,
      QFileDialog::DontConfirmOverwrite);
  if (!path.isEmpty()) path_->setText(path);
}

void FileBox::load() {
  msg::Load::Request request;
  request.path = path_->text().toStdString();
  desk_.ask<msg::Load>("load", request);
}

void FileBox::save() {
  msg::Save::Request request;
  request.path = path_->text().toStdString();
  desk_.ask<msg::Save>("save", request);
}

/// Takes over the node's parameters, unless a person has changed one since: that value is newer.
void FileBox::hear(const dynamic_reconfigure::Config& config) {
  if (changes_ > 0) return;
  for (const auto& word : config.strs) {
    if (word.name == kColoring) coloring_->setCurrentText(QString::fromStdString(word.value));
  }
  for (const auto& truth : config.bools) {
    const auto found = switches_.find(truth.name);
    if (found != switches_.end()) found->second->setChecked(truth.value);
  }
}

void FileBox::change(const dynamic_reconfigure::Config& config) {
  using Reconfigure = dynamic_reconfigure::Reconfigure;
  const std::string service = desk_.link.resolved("live/set_parameters");
  Reconfigure::Request request;
  request.config = config;
  ++changes_;
  desk_.requests.call<Reconfigure>(service, request,
                                   [this, service](const Reconfigure::Response* response) {
                                     --changes_;
                                     if (response) hear(response->config);
                                     else desk_.tell(noAnswer(service), true);
                                   });
}

void FileBox::refresh() { config_topic_.poll(); }

}  // namespace shell_origami
