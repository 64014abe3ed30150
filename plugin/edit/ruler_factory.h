// How the library of the edit plugin gets the ruler from the library of the filters.
#pragma once

#include <QObject>

class EditTool;

namespace vorogeo::plugin {

/// MeshLab asks each library for one object, and its classes of filter and edit plugins cannot be bases of
/// one: so there are two libraries, and only that of the filters holds the core and the indexes. The name of
/// the interface has the version of both, so that libraries of different versions do not meet.
class RulerFactory {
 public:
  virtual ~RulerFactory() = default;
  /// A tool for one view of a document; the view destroys it.
  virtual EditTool* make_ruler() = 0;
};

}  // namespace vorogeo::plugin

Q_DECLARE_INTERFACE(vorogeo::plugin::RulerFactory, VOROGEO_RULER_FACTORY_IID)
