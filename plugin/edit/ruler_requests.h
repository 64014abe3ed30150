// What the ruler asks its worker, and what it gets.
#pragma once

#include <memory>
#include <string>

#include "edit/picked.h"
#include "edit/ruler_surface.h"
#include "layers/path_lines.h"
#include "support/progress.h"

namespace vorogeo::plugin {

struct RulerRequest {
  std::shared_ptr<RulerSurface> surface;
  int drag = 0;  ///< a number for each press of the mouse button; -1: of none
  bool is_field = false;
  bool is_last = false;  ///< of its drag: the answer is kept
  Picked from;
  Picked to;  ///< for a path
};

struct RulerAnswer {
  bool is_field = false;
  PathAnswer path;
  PathLines lines;  ///< of the path
  FieldAnswer field;
  double seconds = 0.0;
  std::string error;

  bool is_on_surface() const {
    return is_field ? field.starts_on_surface : path.starts_on_surface && path.ends_on_surface;
  }
};

/// On the worker's thread. All errors become sentences. \throw Cancelled.
RulerAnswer answer(const RulerRequest& request, const Progress& progress);

}  // namespace vorogeo::plugin
