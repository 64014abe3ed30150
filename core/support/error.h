// The errors that leave the core: those that the public interface names.
#pragma once

#include <string>

#include "vorogeo/errors.h"
