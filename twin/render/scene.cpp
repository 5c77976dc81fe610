// MuJoCo visualization: pose, camera, display options.
#include "twin/render/scene.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace darwinop::twin {
namespace {

constexpr int kMaxGeoms = 1000;
constexpr double kHeadWidthRad = 1.0123;  // horizontal field of view of the head camera, of simulator and robot
constexpr double kDistance = 0.9, kElevation = -15, kLookAt = 0.19;  // m, deg, m above the floor
constexpr const char* kHeadCamera = "head";

/// The root body with the largest subtree mass.
int trunkOf(const mjModel& m) {
  int trunk = 1;
  for (int body = 1; body < m.nbody; ++body)
    if (m.body_parentid[body] == 0 && m.body_subtreemass[body] > m.body_subtreemass[trunk]) trunk = body;
  return trunk;
}

}  // namespace

struct Scene::Parts {
  mjModel* model = nullptr;
  mjData* data = nullptr;
  mjvScene scene{};
  mjvOption option{};
  mjvCamera camera{};
  Viewpoint viewpoint = Viewpoint::kFollow;
  int head = -1, trunk = 1;
  std::array<double, 2> followed{};  // last position of the trunk, m

  explicit Parts(const mjModel& original) : model{mj_copyModel(nullptr, &original)}, data{mj_makeData(model)} {
    mjv_defaultScene(&scene);
    mjv_makeScene(model, &scene, kMaxGeoms);
    scene.flags[mjRND_REFLECTION] = 0;
    mjv_defaultOption(&option);
    mjv_defaultCamera(&camera);
    head = mj_name2id(model, mjOBJ_CAMERA, kHeadCamera);
    trunk = trunkOf(*model);
  }
  ~Parts() {
    mjv_freeScene(&scene);
    mj_deleteData(data);
    mj_deleteModel(model);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  /// Follows the trunk horizontally only; vertical motion of the camera with every step would be unpleasant.
  void follow() {
    for (std::size_t axis = 0; axis < followed.size(); ++axis) {
      const double now = data->xpos[3 * trunk + static_cast<int>(axis)];
      camera.lookat[axis] += now - followed.at(axis);
      followed.at(axis) = now;
    }
  }
};

Scene::Scene(const mjModel& model) {
  if (static_cast<std::size_t>(model.nq) > Pose::kMaxCoordinates)
    throw std::runtime_error("the body has " + std::to_string(model.nq) + " coordinates; at most " +
                             std::to_string(Pose::kMaxCoordinates) + " can be drawn");
  if (mj_name2id(&model, mjOBJ_CAMERA, kHeadCamera) < 0)
    throw std::runtime_error(std::string{"the body has no camera named '"} + kHeadCamera +
                             "': add one to the MuJoCo file");
  parts_ = std::make_unique<Parts>(model);
  mj_forward(parts_->model, parts_->data);
  lookFrom(Viewpoint::kFollow);
}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

void Scene::show(const Pose& pose) noexcept {
  mjData& data = *parts_->data;
  std::copy_n(pose.qpos.begin(), parts_->model->nq, data.qpos);
  data.time = pose.time_s;
  mj_fwdPosition(parts_->model, &data);  // kinematics, cameras, lights, contacts
  parts_->follow();
}

void Scene::lookFrom(Viewpoint viewpoint) noexcept {
  parts_->viewpoint = viewpoint;
  mjvCamera& camera = parts_->camera;
  if (viewpoint == Viewpoint::kHead) {
    camera.type = mjCAMERA_FIXED;
    camera.fixedcamid = parts_->head;
    return;
  }
  camera.type = mjCAMERA_FREE;
  parts_->followed = {};
  mju_zero3(camera.lookat);
  parts_->follow();
  camera.lookat[2] = kLookAt;
  camera.distance = kDistance;
  camera.elevation = kElevation;
  // Azimuth is the viewing direction: 90 looks along +y, from the right of a robot that faces +x.
  camera.azimuth = viewpoint == Viewpoint::kSide ? 90 : viewpoint == Viewpoint::kFront ? 180 : 140;
}

Viewpoint Scene::viewpoint() const noexcept {
  return parts_->viewpoint;
}

void Scene::turn(double right, double down) noexcept {
  mjv_moveCamera(parts_->model, mjMOUSE_ROTATE_H, right, down, &parts_->scene, &parts_->camera);
  mjv_moveCamera(parts_->model, mjMOUSE_ROTATE_V, right, down, &parts_->scene, &parts_->camera);
}

void Scene::shift(double right, double down) noexcept {
  mjv_moveCamera(parts_->model, mjMOUSE_MOVE_V, right, down, &parts_->scene, &parts_->camera);
}

void Scene::zoom(double nearer) noexcept {
  mjv_moveCamera(parts_->model, mjMOUSE_ZOOM, 0, -nearer, &parts_->scene, &parts_->camera);
}

void Scene::showContacts(bool on) noexcept {
  parts_->option.flags[mjVIS_CONTACTPOINT] = on ? 1 : 0;
  parts_->option.flags[mjVIS_TRANSPARENT] = on ? 1 : 0;  // contact points are inside the feet
}

bool Scene::showsContacts() const noexcept {
  return parts_->option.flags[mjVIS_CONTACTPOINT] != 0;
}

void Scene::showShadows(bool on) noexcept {
  parts_->scene.flags[mjRND_SHADOW] = on ? 1 : 0;
}

mjvScene& Scene::forSize(int width, int height) noexcept {
  // MuJoCo's field of view is vertical, the robot's is horizontal; pixels are square.
  const double aspect = static_cast<double>(height) / width;
  parts_->model->cam_fovy[parts_->head] = 2 * std::atan(std::tan(kHeadWidthRad / 2) * aspect) * 180 / mjPI;
  mjv_updateScene(parts_->model, parts_->data, &parts_->option, nullptr, &parts_->camera, mjCAT_ALL, &parts_->scene);
  return parts_->scene;
}

const mjModel& Scene::model() const noexcept {
  return *parts_->model;
}

void Scene::reserve(int width, int height, bool smooth_edges, bool shadows) noexcept {
  parts_->model->vis.quality.offsamples = smooth_edges ? 4 : 0;
  parts_->model->vis.quality.shadowsize = shadows ? 2048 : 0;
  parts_->model->vis.global.offwidth = width;
  parts_->model->vis.global.offheight = height;
}

}  // namespace darwinop::twin
