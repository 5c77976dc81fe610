// Visual scene of the twin: a copy of the model, a pose, and a viewpoint.
#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "twin/render/pose.hpp"

struct mjModel_;
struct mjvScene_;

namespace darwinop::twin {

enum class Viewpoint {
  kFollow,  // from the front right, follows the trunk
  kSide,    // from the robot's right, follows
  kFront,   // from the front, follows
  kHead,    // the robot's head camera
};
constexpr std::array<std::string_view, 4> kViewpoints{"follow", "side", "front", "head"};

/// Has its own copy of the model, so that drawing does not block the simulation. Not thread-safe.
class Scene {
 public:
  /// Throws std::runtime_error for a model without head camera or with more coordinates than a Pose holds.
  explicit Scene(const mjModel_& model);
  ~Scene();
  Scene(Scene&&) noexcept;
  Scene& operator=(Scene&&) noexcept;

  void show(const Pose& pose) noexcept;
  void lookFrom(Viewpoint viewpoint) noexcept;
  [[nodiscard]] Viewpoint viewpoint() const noexcept;

  // Mouse control, in fractions of the picture height. No effect on Viewpoint::kHead.
  void turn(double right, double down) noexcept;
  void shift(double right, double down) noexcept;
  void zoom(double nearer) noexcept;

  void showContacts(bool on) noexcept;
  void showShadows(bool on) noexcept;
  [[nodiscard]] bool showsContacts() const noexcept;

  /// For renderers: the scene for a picture of this size, and the model for the rendering context.
  [[nodiscard]] mjvScene_& forSize(int width, int height) noexcept;
  [[nodiscard]] const mjModel_& model() const noexcept;
  /// Sets the offscreen buffer size. Call before the rendering context is created.
  void reserve(int width, int height, bool smooth_edges, bool shadows) noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace darwinop::twin
