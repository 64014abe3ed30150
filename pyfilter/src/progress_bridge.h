// Carries the core's progress reports to a Python function, and Ctrl-C back.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <chrono>
#include <exception>
#include <string>

#include "support/progress.h"

namespace vorogeo::python {

namespace nb = nanobind;

/// Runs a computation without the GIL; takes it only to report.
///
/// The Python function is called with (fraction, text) when the text changes, at the end, and at most fifty
/// times a second in between; the fraction never decreases. A result of False (Python's or numpy's) cancels;
/// any other, including 0 and None, continues. An exception of the function, or Ctrl-C, stops the computation
/// and is raised unchanged.
class ProgressBridge {
 public:
  /// `function`: a callable, or None for Ctrl-C alone. Both `function` and this object outlive the run.
  explicit ProgressBridge(nb::handle function) : function_(function) {}
  ProgressBridge(const ProgressBridge&) = delete;
  ProgressBridge& operator=(const ProgressBridge&) = delete;

  /// Calls `body(progress)` with the GIL released. The caller holds the GIL.
  template <class Body>
  auto run(Body&& body) {
    const Progress progress(
        [this](double fraction, const std::string& activity) { return report(fraction, activity); },
        [this](const std::string& sentence) { return warn(sentence); });
    try {
      nb::gil_scoped_release release;
      return body(progress);
    } catch (const Cancelled&) {
      if (failure_) std::rethrow_exception(failure_);
      throw;
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr auto interval = std::chrono::milliseconds(20);
  bool report(double fraction, const std::string& activity) {
    const auto now = Clock::now();
    const bool news = activity != activity_ || (fraction >= 1.0 && fraction_ < 1.0);
    if (!news && now - last_ < interval) return true;
    last_ = now;
    activity_ = activity;
    fraction_ = fraction > 1.0 ? 1.0 : (fraction > fraction_ ? fraction : fraction_);

    nb::gil_scoped_acquire acquire;
    try {
      if (PyErr_CheckSignals() != 0) throw nb::python_error();
      if (function_.is_none()) return true;
      const nb::object answer = function_(fraction_, activity_);
      return !is_false(answer);
    } catch (...) {
      failure_ = std::current_exception();
      return false;
    }
  }

  /// Issues a UserWarning at the line that called the package; if a warning filter of Python makes it an
  /// exception, that stops the computation.
  bool warn(const std::string& sentence) {
    nb::gil_scoped_acquire acquire;
    Py_ssize_t level = 1;
    nb::object frame = nb::module_::import_("sys").attr("_getframe")();
    for (; !frame.is_none() && is_of_the_package(frame); ++level) frame = frame.attr("f_back");
    if (PyErr_WarnEx(PyExc_UserWarning, sentence.c_str(), level) == 0) return true;
    failure_ = std::make_exception_ptr(nb::python_error());
    return false;
  }

  static bool is_of_the_package(nb::handle frame) {
    const std::string module =
        nb::cast<std::string>(nb::str(frame.attr("f_globals").attr("get")("__name__")));
    return module.starts_with("vorogeo.");
  }

  /// Also numpy's False, which comparisons of numpy numbers return.
  static bool is_false(nb::handle answer) {
    if (answer.ptr() == Py_False || answer.ptr() == Py_True || answer.is_none()) {
      return answer.ptr() == Py_False;
    }
    const nb::object numpy_bool = nb::module_::import_("numpy").attr("bool_");
    return nb::isinstance(answer, numpy_bool) && !nb::cast<bool>(nb::bool_(answer));
  }

  nb::handle function_;
  Clock::time_point last_{};
  std::string activity_;
  double fraction_ = 0.0;
  std::exception_ptr failure_;
};

}  // namespace vorogeo::python
