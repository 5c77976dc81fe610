// Finds, checks and loads the twin's library, which stays loaded until the program ends.
#include "connect/twin_library.hpp"

#include <charconv>
#include <cstdlib>
#include <stdexcept>

#include "hal/body_library.hpp"

// Defined by the build on a PC only. A robot's programs are static and cannot load libraries.
#ifdef DARWINOP_TWIN_FOLDERS
#include <dlfcn.h>

#include <array>
#include <filesystem>
#endif

namespace darwinop::connect {

std::uint64_t twinSeed() {
  const char* const text = std::getenv("DARWINOP_TWIN_SEED");
  if (text == nullptr || *text == '\0') return 1;
  const std::string_view digits{text};
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), seed);
  if (error != std::errc{} || end != digits.end())
    throw std::runtime_error("DARWINOP_TWIN_SEED = " + std::string{digits} + ": give a whole number, 0 or more");
  return seed;
}

#ifndef DARWINOP_TWIN_FOLDERS

std::vector<std::string> twinLibraryPlaces() {
  return {};
}

std::unique_ptr<Body> makeTwin(const std::string& /*model*/, std::uint64_t /*seed*/) {
  throw std::runtime_error(
      "the physics twin runs on a PC only, and this program was built for the robot; here there is 'virtual', or the "
      "robot itself");
}

#else

namespace {

constexpr const char* kVariable = "DARWINOP_TWIN_LIBRARY";

/// Result of `make`; throws its error message.
template <class Make>
void* orThrow(Make&& make) {
  std::array<char, 2000> error{};
  void* const made = make(error.data(), error.size());
  if (made == nullptr) throw std::runtime_error(error.data());
  return made;
}

class LibraryCamera final : public BodyCamera {
 public:
  LibraryCamera(const BodyLibrary& library, void* camera) : library_{library}, camera_{camera} {}
  ~LibraryCamera() override { library_.close_camera(camera_); }
  LibraryCamera(const LibraryCamera&) = delete;
  LibraryCamera& operator=(const LibraryCamera&) = delete;

  void look() noexcept override { library_.look(camera_); }
  CameraFrame newest() override {
    BodyPicture picture{};
    library_.newest(camera_, &picture);
    if (picture.sequence != shown_) ++frames_;
    shown_ = picture.sequence;
    render_error_ = picture.render_error;
    const auto bytes = 4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    return {picture.sequence, Nanos{picture.time_ns}, picture.width, picture.height, {picture.bgra, bytes}};
  }
  [[nodiscard]] CameraHealth health() const override {
    return {.seeing = shown_ != 0 && render_error_ == nullptr, .frames = frames_};
  }
  [[nodiscard]] const char* renderError() const noexcept override { return render_error_; }

 private:
  const BodyLibrary& library_;
  void* camera_;
  std::uint64_t shown_ = 0, frames_ = 0;
  const char* render_error_ = nullptr;  // the library's
};

class LibraryBody final : public Body {
 public:
  LibraryBody(const BodyLibrary& library, void* body) : library_{library}, body_{body} {}
  ~LibraryBody() override { library_.end(body_); }
  LibraryBody(const LibraryBody&) = delete;
  LibraryBody& operator=(const LibraryBody&) = delete;

  void step(Nanos dt, const Drives& drives) noexcept override { library_.step(body_, dt.count(), drives.data()); }
  [[nodiscard]] const BodyState& state() const noexcept override { return *library_.state(body_); }
  [[nodiscard]] const char* error() const noexcept override { return library_.error(body_); }
  bool clamp(const std::array<double, 3>& up) noexcept override { return library_.clamp(body_, up.data()); }
  [[nodiscard]] std::unique_ptr<BodyCamera> openCamera(int width, int height) override {
    return std::make_unique<LibraryCamera>(library_, orThrow([&](char* error, std::size_t size) {
                                             return library_.open_camera(body_, width, height, error, size);
                                           }));
  }

 private:
  const BodyLibrary& library_;
  void* body_;
};

std::string dlProblem() {
  const char* const text = dlerror();
  return text == nullptr ? "unknown reason" : text;
}

std::string findLibrary() {
  std::string looked;
  for (const std::string& place : twinLibraryPlaces()) {
    std::error_code unreadable;
    if (std::filesystem::exists(place, unreadable)) return place;
    looked += "\n  " + place;
  }
  throw std::runtime_error("the physics twin is a library of its own, " + std::string{kTwinLibraryFile} +
                           ", and it was not found. Looked for:" + looked +
                           "\nBuild it with ./dev build, or say with " + kVariable + " where it is");
}

const BodyLibrary& load(const std::string& path) {
  void* const handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr)
    throw std::runtime_error("the physics twin cannot be loaded: " + dlProblem() +
                             ". Are the packages of ./dev help packages installed (libmujoco)?");
  void* const entry = dlsym(handle, kBodyLibraryEntry);
  if (entry == nullptr)
    throw std::runtime_error(path + " is not a library of the physics twin: " + dlProblem() + ". Correct " + kVariable);
  const BodyLibrary* const library = reinterpret_cast<BodyLibraryEntry>(entry)();
  const std::string ours = bodyLibraryVersion(DARWINOP_VERSION);
  const std::string theirs = library == nullptr ? "none" : library->version;
  if (ours != theirs)
    throw std::runtime_error(path + " belongs to another version (" + theirs + "), this program needs " + ours +
                             ". Build both from the same sources: ./dev build, then the controller again");
  return *library;
}

}  // namespace

std::vector<std::string> twinLibraryPlaces() {
  namespace fs = std::filesystem;
  if (const char* const said = std::getenv(kVariable); said != nullptr && *said != '\0')
    return {fs::absolute(said).string()};
  std::vector<std::string> places;
  std::error_code unknown;
  const fs::path home = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const char* const folder : {DARWINOP_TWIN_FOLDERS}) {
    // A relative path is relative to the parent of the program's folder, as lib is beside bin.
    const fs::path place = (home.parent_path() / folder / kTwinLibraryFile).lexically_normal();
    if (places.empty() || places.back() != place) places.push_back(place);
  }
  return places;
}

std::unique_ptr<Body> makeTwin(const std::string& model, std::uint64_t seed) {
  const BodyLibrary& library = load(findLibrary());
  void* const body =
      orThrow([&](char* error, std::size_t size) { return library.make(model.c_str(), seed, error, size); });
  return std::make_unique<LibraryBody>(library, body);
}

#endif

}  // namespace darwinop::connect
