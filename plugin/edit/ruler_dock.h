// The dock of the ruler: how to measure, what answers, the table of measurements and the buttons.
#pragma once

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <functional>
#include <vector>

#include "edit/measurements.h"
#include "edit/ruler_surface.h"

namespace vorogeo::plugin {

/// Shows what it is told and says what was pressed.
class RulerDock : public QDockWidget {
 public:
  struct Actions {
    std::function<void()> prepare;
    std::function<void()> cancel;
    std::function<void()> copy;
    std::function<void()> save;
    std::function<void()> open;
    std::function<void(const std::vector<int>& numbers)> remove;
    std::function<void()> undo;
    std::function<void()> measure_again;
    std::function<void(MeasureKind kind)> choose_kind;
    std::function<void(LengthUnit unit)> choose_unit;
    std::function<void(SnapTo to)> choose_snap;
    std::function<void(const RulerMetric& metric)> choose_metric;
    std::function<void(int number, const std::string& name)> rename;
    std::function<void(int number, bool is_hidden)> hide;
  };
  RulerDock(QWidget* parent, Actions actions);

  void show_measurements(const Measurements& measurements);
  /// What answers now, or why nothing does; while the mouse drags, what is shown.
  void show_status(const QString& text) { status_->setText(text); }
  void show_snap(SnapTo to) { snap_->setCurrentIndex(static_cast<int>(to)); }
  /// Whether there is a button that builds an index.
  void offer_preparation(bool is_offered);
  void show_preparation(double fraction);
  /// As a filter of events it takes the keys that copy, delete and undo, for its own widgets and for others.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// The measurements of the selected rows; that of the last row if none is selected.
  std::vector<int> chosen() const;
  void change(int row, int column);
  void change_metric();

  Actions actions_;
  QLabel* hint_;
  QComboBox* unit_;
  QComboBox* snap_;
  QComboBox* metric_;
  QLineEdit* weight_;
  QLineEdit* gap_;
  QLabel* status_;
  QTableWidget* table_;
  QPushButton* prepare_;
  QPushButton* save_;
  bool is_preparing_ = false;
};

}  // namespace vorogeo::plugin
