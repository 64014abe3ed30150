// The widgets of the dock.
#include "edit/ruler_dock.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>
#include <string>
#include <utility>

namespace vorogeo::plugin {

namespace {

constexpr int name_column = 1;
constexpr const char* help =
    "\nShift and drag: distances from a point. Ctrl and drag: move a point."
    "\nBackspace, Esc: a step back; then Esc: the camera, and back; C: at any time.";

}  // namespace

RulerDock::RulerDock(QWidget* parent, Actions actions)
    : QDockWidget("Geodesic ruler", parent), actions_(std::move(actions)) {
  auto* body = new QWidget(this);
  auto* rows = new QVBoxLayout(body);
  auto* choices = new QHBoxLayout;
  auto* costs = new QHBoxLayout;
  const auto add_choice = [&](QHBoxLayout* row, const char* tip, const auto& names) {
    auto* box = new QComboBox(body);
    box->setToolTip(tip);
    for (const char* name : names) box->addItem(name);
    box->view();  // made now, so that eventFilter() gets the keys of its list
    row->addWidget(box);
    return box;
  };
  const auto add_number = [&](const char* name, const char* tip) {
    auto* field = new QLineEdit(body);
    field->setPlaceholderText(name);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    costs->addWidget(field);
    connect(field, &QLineEdit::editingFinished, this, &RulerDock::change_metric);
    return field;
  };
  std::vector<const char*> kind_names;
  for (const KindOfMeasure& kind : kinds) kind_names.push_back(kind.name);
  auto* kind_box = add_choice(choices, "What is measured next.", kind_names);
  unit_ = add_choice(choices, "What the coordinates count in; values are not converted.", unit_names);
  snap_ =
      add_choice(choices,
                 "Where points come to lie: where the mouse is, at the nearest corner or side of the face "
                 "there, or on the border. The keys do the same while the mouse drags.",
                 snap_names);
  metric_ = add_choice(costs,
                       "What paths cost, as in the filters: their length, the quality as a cost, more on "
                       "slopes, or more across ridges and limbs.",
                       ruler_metrics);
  weight_ = add_number("weight", "Of the slope penalty, or along curvature; see the filters.");
  gap_ = add_number("gap", "Borders at most this far apart are bridged; crossing a gap costs its width.");
  weight_->setEnabled(false);
  rows->addLayout(choices);
  rows->addLayout(costs);
  hint_ = new QLabel(QString(kinds.front().hint) + help, body);
  hint_->setWordWrap(true);
  rows->addWidget(hint_);
  const auto chosen_one = QOverload<int>::of(&QComboBox::activated);
  connect(kind_box, chosen_one, this, [this](int number) {
    hint_->setText(QString(kinds[static_cast<std::size_t>(number)].hint) + help);
    actions_.choose_kind(static_cast<MeasureKind>(number));
  });
  connect(unit_, chosen_one, this,
          [this](int number) { actions_.choose_unit(static_cast<LengthUnit>(number)); });
  connect(snap_, chosen_one, this, [this](int number) { actions_.choose_snap(static_cast<SnapTo>(number)); });
  connect(metric_, chosen_one, this, [this](int number) {
    const double weight = usual_weights[static_cast<std::size_t>(number)];
    weight_->setEnabled(weight > 0.0);
    weight_->setText(weight > 0.0 ? QString::number(weight) : QString());
    change_metric();
  });
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
  // Queued, as the table is filled anew while the item that reports its change is still in use.
  connect(table_, &QTableWidget::cellChanged, this, &RulerDock::change, Qt::QueuedConnection);
  rows->addWidget(table_);

  auto* buttons = new QHBoxLayout;
  auto* more_buttons = new QHBoxLayout;
  const auto add_button = [&](const char* text, const char* tip, const std::function<void()>& pressed) {
    auto* button = new QPushButton(text, body);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, pressed);
    (buttons->count() < 4 ? buttons : more_buttons)->addWidget(button);
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
  add_button("Open...",
             "Adds the measurements of such a CSV file; those on the current layer get their lines.",
             [this] { actions_.open(); });
  add_button("Delete", "Removes the selected measurements, or the last one (Delete).",
             [this] { actions_.remove(chosen()); });
  add_button("Undo", "Takes the last change of the table back (Ctrl+Z).", [this] { actions_.undo(); });
  add_button("Measure again", "Measures again what was measured on the current layer before an edit.",
             [this] { actions_.measure_again(); });
  rows->addLayout(buttons);
  rows->addLayout(more_buttons);
  setWidget(body);

  for (QWidget* child : body->findChildren<QWidget*>()) {
    if (qobject_cast<QLineEdit*>(child) == nullptr) child->installEventFilter(this);
  }
}

/// The main window has shortcuts for some of these keys, which win unless the widget with the focus claims
/// them.
bool RulerDock::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<const QKeyEvent*>(event);
    const bool is_copy = key->matches(QKeySequence::Copy);
    const bool is_delete = key->matches(QKeySequence::Delete);
    const bool is_undo = key->matches(QKeySequence::Undo);
    const bool closes_list = key->key() == Qt::Key_Escape && QApplication::activePopupWidget() != nullptr;
    if (closes_list && event->type() == QEvent::ShortcutOverride) {
      event->accept();
      return true;
    }
    if (is_copy || is_delete || is_undo) {
      event->accept();
      if (event->type() == QEvent::KeyPress && is_copy) actions_.copy();
      if (event->type() == QEvent::KeyPress && is_delete) actions_.remove(chosen());
      if (event->type() == QEvent::KeyPress && is_undo) actions_.undo();
      return true;
    }
  }
  return QDockWidget::eventFilter(watched, event);
}

void RulerDock::show_measurements(const Measurements& measurements) {
  const QSignalBlocker no_changes(table_);
  const auto& all = measurements.all();
  table_->setRowCount(static_cast<int>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<std::string> cells = measurements.row(all[i]);
    for (std::size_t j = 0; j < cells.size(); ++j) {
      auto* item = new QTableWidgetItem(QString::fromStdString(cells[j]));
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
      if (j == name_column) {
        item->setFlags(item->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
        item->setCheckState(all[i].is_hidden ? Qt::Unchecked : Qt::Checked);
        item->setToolTip("Double-click: another name. Without the tick, it is hidden in the view.");
      }
      table_->setItem(static_cast<int>(i), static_cast<int>(j), item);
    }
  }
  table_->scrollToBottom();
  save_->setEnabled(!all.empty());
  unit_->setCurrentIndex(static_cast<int>(measurements.unit()));
}

/// Text that is no number becomes NaN, which the metric refuses in a sentence.
void RulerDock::change_metric() {
  const auto number_in = [](const QLineEdit* field) {
    bool is_number = true;
    const double number = field->text().isEmpty() ? 0.0 : field->text().toDouble(&is_number);
    return is_number ? number : std::nan("");
  };
  RulerMetric metric{static_cast<LayerMetric>(metric_->currentIndex()), 0.0, number_in(gap_)};
  if (metric.has_weight()) metric.weight = number_in(weight_);
  actions_.choose_metric(metric);
}

/// The user has changed the name or the tick of a row.
void RulerDock::change(int row, int column) {
  const QTableWidgetItem* item = column == name_column ? table_->item(row, column) : nullptr;
  if (item == nullptr) return;
  const int number = table_->item(row, 0)->text().toInt();
  const bool is_hidden = item->checkState() == Qt::Unchecked;
  const std::string name = item->text().toStdString();
  actions_.hide(number, is_hidden);
  actions_.rename(number, name);
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
