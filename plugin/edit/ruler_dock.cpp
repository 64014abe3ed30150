// The widgets of the dock.
#include "edit/ruler_dock.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QVBoxLayout>
#include <utility>

namespace vorogeo::plugin {

RulerDock::RulerDock(QWidget* parent, Actions actions)
    : QDockWidget("Geodesic ruler", parent), actions_(std::move(actions)) {
  auto* body = new QWidget(this);
  auto* rows = new QVBoxLayout(body);
  auto* hint = new QLabel(
      "Drag on the surface: shortest path. With Shift: distances from the point. Esc: move the camera, and "
      "back.",
      body);
  hint->setWordWrap(true);
  rows->addWidget(hint);
  status_ = new QLabel(body);
  status_->setWordWrap(true);
  rows->addWidget(status_);

  const std::vector<std::string> columns = Measurements::columns();
  table_ = new QTableWidget(0, static_cast<int>(columns.size()), body);
  QStringList names;
  for (const std::string& column : columns) names << QString::fromStdString(column);
  table_->setHorizontalHeaderLabels(names);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  rows->addWidget(table_);

  auto* buttons = new QHBoxLayout;
  const auto add_button = [&](const char* text, const char* tip, const std::function<void()>& pressed) {
    auto* button = new QPushButton(text, body);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, pressed);
    buttons->addWidget(button);
    return button;
  };
  prepare_ = add_button(
      "Prepare",
      "Builds the index, which the filters use as well: then paths are found in about a millisecond on large "
      "meshes, too. The window stays usable, and you can cancel.",
      [this] { (is_preparing_ ? actions_.cancel : actions_.prepare)(); });
  add_button("Copy", "Copies the table (Ctrl+C).", [this] { actions_.copy(); });
  save_ = add_button("Save...",
                     "Adds a layer with all paths on the current layer, and writes the table to a CSV file.",
                     [this] { actions_.save(); });
  add_button("Delete", "Removes the selected measurements, or the last one (Delete).",
             [this] { actions_.remove(chosen()); });
  rows->addLayout(buttons);
  setWidget(body);

  for (QWidget* child : body->findChildren<QWidget*>()) child->installEventFilter(this);
}

/// The main window has shortcuts for some of these keys, which win unless the widget with the focus claims
/// them.
bool RulerDock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<const QKeyEvent*>(event);
    const bool is_copy = key->matches(QKeySequence::Copy);
    const bool is_delete = key->matches(QKeySequence::Delete);
    if (is_copy || is_delete) {
      event->accept();
      if (event->type() == QEvent::KeyPress && is_copy) actions_.copy();
      if (event->type() == QEvent::KeyPress && is_delete) actions_.remove(chosen());
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

void RulerDock::show_measurements(const Measurements& measurements) {
  const auto& all = measurements.all();
  table_->setRowCount(static_cast<int>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<std::string> cells = Measurements::row(all[i]);
    for (std::size_t j = 0; j < cells.size(); ++j) {
      table_->setItem(static_cast<int>(i), static_cast<int>(j),
                      new QTableWidgetItem(QString::fromStdString(cells[j])));
    }
  }
  table_->scrollToBottom();
  save_->setEnabled(!all.empty());
}

void RulerDock::offer_preparation(bool is_offered) {
  is_preparing_ = false;
  prepare_->setVisible(is_offered);
  prepare_->setText("Prepare");
}

void RulerDock::show_preparation(double fraction) {
  is_preparing_ = true;
  prepare_->setVisible(true);
  prepare_->setText(QString("Cancel (%1 %)").arg(static_cast<int>(100.0 * fraction)));
}

std::vector<int> RulerDock::chosen() const {
  std::vector<int> numbers;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows()) {
    numbers.push_back(table_->item(row.row(), 0)->text().toInt());
  }
  if (numbers.empty() && table_->rowCount() > 0) {
    numbers.push_back(table_->item(table_->rowCount() - 1, 0)->text().toInt());
  }
  return numbers;
}

}  // namespace vorogeo::plugin
