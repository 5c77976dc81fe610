// Loads the physics twin from its shared library on demand.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hal/body.hpp"

namespace darwinop::connect {

/// Default model.
inline const std::string kUsualTwin = "darwin-op";

/// "model" in the head of a twin's recordings. `model`: as for makeTwin().
inline std::string twinInHead(const std::string& model) {
  return "twin in memory, model " + (model.empty() ? kUsualTwin : model);
}

/// A body with physics. `model`: name or INI file; empty: the default. `seed`: for sensor noise; the model has another
/// seed for lost packets. Throws std::runtime_error with a remedy if the library is missing, has another version, or
/// rejects the model.
std::unique_ptr<Body> makeTwin(const std::string& model, std::uint64_t seed);

/// DARWINOP_TWIN_SEED, or 1. Throws std::runtime_error if it is not a number.
std::uint64_t twinSeed();

/// Paths to try, in order: only DARWINOP_TWIN_LIBRARY if set, else beside the running program, else where it was built
/// or installed.
std::vector<std::string> twinLibraryPlaces();

}  // namespace darwinop::connect
