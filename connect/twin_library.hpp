// The physics twin, loaded from its shared library when somebody asks for it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hal/body.hpp"

namespace darwinop::connect {

/// The model that is meant when none is named.
inline const std::string kUsualTwin = "darwin-op";

/// A robot with physics. `model`: name or INI file, empty for the usual one. `seed`: of the noise of its sensors; lost
/// packets have one of their own in the model. Throws
/// std::runtime_error with what to do when there is no library, it is another version's, or it refuses the model.
std::unique_ptr<Body> makeTwin(const std::string& model, std::uint64_t seed);

/// DARWINOP_TWIN_SEED, or 1. Throws std::runtime_error when it is no number.
std::uint64_t twinSeed();

/// Where the library is looked for, first one first: DARWINOP_TWIN_LIBRARY alone if that is set, else beside the
/// running program, else where it was built or installed.
std::vector<std::string> twinLibraryPlaces();

}  // namespace darwinop::connect
