// GLFW window with mouse and keyboard control.
#include "twin/view/window.hpp"

#include <GLFW/glfw3.h>
#include <mujoco/mujoco.h>

#include <array>
#include <utility>

namespace darwinop::twin {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 9> kHelp{{
    {"drag left", "turn"},
    {"drag right", "move"},
    {"wheel", "nearer, farther"},
    {"Tab", "next camera: follow, side, front, head"},
    {"Space", "push the robot forward"},
    {"R", "back to the start pose"},
    {"C", "contacts"},
    {"S", "shadows"},
    {"H, Esc", "this help; close"},
}};

[[noreturn]] void refuse(const char* what) {
  const char* why = nullptr;
  glfwGetError(&why);
  throw NoDisplay(std::string{what} + (why == nullptr ? "" : std::string{" ("} + why + ")"));
}

}  // namespace

struct ViewWindow::Parts {
  /// Initializes and terminates the library.
  struct Glfw {
    Glfw() {
      if (glfwInit() == GLFW_FALSE) refuse("cannot open a display");
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
  } glfw;
  Scene scene;
  WindowKeys keys;
  GLFWwindow* window = nullptr;
  mjrContext context{};
  std::string line;
  bool help = false, shadows = true;
  double mouse_x = 0, mouse_y = 0;

  Parts(const mjModel& model, WindowKeys wanted) : scene{model}, keys{std::move(wanted)} {
    mjr_defaultContext(&context);
  }
  ~Parts() {
    if (window == nullptr) return;
    mjr_freeContext(&context);
    glfwDestroyWindow(window);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  static Parts& of(GLFWwindow* window) { return *static_cast<Parts*>(glfwGetWindowUserPointer(window)); }

  void open(int width, int height, const std::string& title) {
    glfwWindowHint(GLFW_VISIBLE, GLFW_TRUE);
    window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (window == nullptr) refuse("cannot open a window on this display");
    glfwMakeContextCurrent(window);
    glfwSwapInterval(0);  // the pose rate sets the pace
    mjr_makeContext(&scene.model(), &context, mjFONTSCALE_100);
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
      if (action == GLFW_PRESS) of(w).key(key);
    });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { of(w).moved(x, y); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double y) { of(w).scene.zoom(0.05 * y); });
  }

  void key(int key) {
    switch (key) {
      case GLFW_KEY_TAB:
        scene.lookFrom(static_cast<Viewpoint>((static_cast<std::size_t>(scene.viewpoint()) + 1) % kViewpoints.size()));
        break;
      case GLFW_KEY_SPACE:
        keys.push();
        break;
      case GLFW_KEY_R:
        keys.reset();
        break;
      case GLFW_KEY_C:
        scene.showContacts(!scene.showsContacts());
        break;
      case GLFW_KEY_S:
        shadows = !shadows;
        scene.showShadows(shadows);
        break;
      case GLFW_KEY_H:
        help = !help;
        break;
      case GLFW_KEY_ESCAPE:
        glfwSetWindowShouldClose(window, GLFW_TRUE);
        break;
      default:
        break;
    }
  }

  void moved(double x, double y) {
    int width = 1, height = 1;
    glfwGetWindowSize(window, &width, &height);
    const double right = (x - mouse_x) / height, down = (y - mouse_y) / height;
    mouse_x = x;
    mouse_y = y;
    if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS)
      scene.turn(right, down);
    else if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS)
      scene.shift(right, down);
  }

  void overlay(const mjrRect& area) const {
    if (help) {
      std::string left, right;
      for (const auto& [input, effect] : kHelp) {
        left += std::string{input} + '\n';
        right += std::string{effect} + '\n';
      }
      mjr_overlay(mjFONT_NORMAL, mjGRID_BOTTOMLEFT, area, left.c_str(), right.c_str(), &context);
    }
    mjr_overlay(mjFONT_NORMAL, mjGRID_TOPLEFT, area, line.c_str(), nullptr, &context);
  }
};

ViewWindow::ViewWindow(const mjModel& model, int width, int height, const std::string& title, WindowKeys keys)
    : parts_{std::make_unique<Parts>(model, std::move(keys))} {
  parts_->open(width, height, title);
}

ViewWindow::~ViewWindow() = default;

Scene& ViewWindow::scene() noexcept {
  return parts_->scene;
}

void ViewWindow::setLine(const std::string& line) {
  parts_->line = line;
}

void ViewWindow::pollEvents() {
  glfwPollEvents();
}

bool ViewWindow::closed() const noexcept {
  return glfwWindowShouldClose(parts_->window) == GLFW_TRUE;
}

void ViewWindow::draw() {
  mjrRect area{0, 0, 0, 0};
  glfwGetFramebufferSize(parts_->window, &area.width, &area.height);
  if (area.width < 1 || area.height < 1) return;  // minimised
  mjr_render(area, &parts_->scene.forSize(area.width, area.height), &parts_->context);
  parts_->overlay(area);
  glfwSwapBuffers(parts_->window);
}

}  // namespace darwinop::twin
