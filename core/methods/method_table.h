// The table of all geodesic methods, by their names.
#pragma once

#include "methods/method.h"

namespace vorogeo {

// Each in the file of its name.
MethodEntry mmp_entry();
MethodEntry ammp_entry();
MethodEntry ch_entry();  // in chen_han.cpp, with ich
MethodEntry ich_entry();
MethodEntry fast_marching_entry();
MethodEntry heat_entry();
MethodEntry svg_entry();
MethodEntry dgg_entry();
MethodEntry gsp_entry();
MethodEntry gtu_entry();
MethodEntry campen_kobbelt_entry();
MethodEntry stvd_entry();
MethodEntry dijkstra_entry();
MethodEntry vorogeo_entry();

/// In the order in which they are offered.
const std::vector<MethodEntry>& all_methods();

/// \throw InvalidInput for a name that is not known; it lists those that are.
const MethodEntry& method_named(const std::string& name);

/// Options of a method with standard values for those that are not given.
/// \throw InvalidInput for an unknown option, or a value out of range.
MethodOptions completed_options(const MethodInfo& info, const MethodOptions& given);

/// Prepares a method. Options that are not given have their standard value.
/// \throw InvalidInput for an unknown name or option, or a value out of range; Cancelled.
std::unique_ptr<GeodesicMethod> prepare_method(const std::string& name,
                                               const std::shared_ptr<const Mesh>& mesh,
                                               const MethodOptions& given, const Progress& progress);

}  // namespace vorogeo
