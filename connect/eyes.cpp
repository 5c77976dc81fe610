#include "connect/eyes.hpp"

#include <sys/stat.h>

#include <stdexcept>

#include "connect/robot_file.hpp"
#include "hal/camera_v4l2/monotonic.hpp"
#include "hal/shared_picture/writer.hpp"
#include "runtime/daemon_link.hpp"

namespace darwinop::connect {
namespace {

/// Onlookers are the daemon's group's. That they see nothing stops nobody: it is said.
v4l2::RawFrameTaker showOnlookers(const runtime::RuntimeFiles& files,
                                  const std::function<void(const std::string&)>& say) {
  struct stat exchange {};
  if (::stat(files.exchange.c_str(), &exchange) != 0) return {};  // the daemon has just ended
  try {
    auto writer = std::make_shared<shared_picture::Writer>(
        shared_picture::WindowFiles{files.pictures, files.pictures_asked}, exchange.st_gid);
    return [writer = std::move(writer)](const pixels::YuyvImage& image, std::uint64_t sequence, Nanos time) {
      (void)writer->put(image, sequence, time, v4l2::monotonicNow());
    };
  } catch (const std::runtime_error& error) {
    if (say) say(std::string{"onlookers of darwinop monitor see no pictures while this drives: "} + error.what());
    return {};
  }
}

}  // namespace

std::unique_ptr<FrameSource> openCamera(const EyesRequest& request) {
  v4l2::CameraOptions options;
  if (const RobotFile file = readRobotFile(); file.camera) options.device = *file.camera;
  options.width = request.width;
  options.height = request.height;
  options.settings = request.settings;
  options.form = request.form;
  options.say = request.say;
  if (request.onlookers) options.on_raw_frame = showOnlookers(*request.onlookers, request.say);
  return std::make_unique<v4l2::Camera>(std::move(options));
}

std::unique_ptr<FrameSource> openEyes(runtime::RobotLink& robot, const EyesRequest& request) {
  if (auto its_own = robot.openEyes(request.width, request.height)) return its_own;
  // A camera of this computer shows another world than the simulated one.
  if (!robot.realTime()) throw std::runtime_error("this virtual robot has no camera: the twin has one, --robot twin");
  EyesRequest seen = request;
  if (const auto* const daemon = dynamic_cast<const runtime::DaemonLink*>(&robot)) seen.onlookers = daemon->files();
  return openCamera(seen);
}

}  // namespace darwinop::connect
