// The twin as something to look at: a model of its own, the pose it stands in, and from where it is looked at.
#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "twin/render/pose.hpp"

struct mjModel_;
struct mjvScene_;

namespace darwinop::twin {

enum class Viewpoint {
  kFollow,  // from the front and the right, moves along with the trunk
  kSide,    // from the robot's right, moves along
  kFront,   // moves along
  kHead,    // what the robot's camera sees
};
constexpr std::array<std::string_view, 4> kViewpoints{"follow", "side", "front", "head"};

/// Works on a copy of the model, so nobody has to wait while it is drawn. Not thread-safe.
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

  // -- by hand; shares of the height of the picture. The head cannot be moved this way.
  void turn(double right, double down) noexcept;
  void shift(double right, double down) noexcept;
  void zoom(double nearer) noexcept;

  void showContacts(bool on) noexcept;
  void showShadows(bool on) noexcept;
  [[nodiscard]] bool showsContacts() const noexcept;

  /// For whoever draws: the scene for a picture of this size, and the model that the drawing context is made from.
  [[nodiscard]] mjvScene_& forSize(int width, int height) noexcept;
  [[nodiscard]] const mjModel_& model() const noexcept;
  /// Room for pictures drawn off screen. Before the drawing context is made.
  void reserve(int width, int height, bool smooth_edges, bool shadows) noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace darwinop::twin
