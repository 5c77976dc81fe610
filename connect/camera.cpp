#include "connect/camera.hpp"

#include <sys/stat.h>

#include <stdexcept>

#include "connect/messages.hpp"
#include "connect/robot_file.hpp"
#include "hal/camera_v4l2/monotonic.hpp"
#include "hal/shared_picture/writer.hpp"
#include "runtime/daemon_link.hpp"

namespace darwinop::connect {
namespace {

/// Shares raw frames with observers of the daemon's group. A failure is logged and not fatal.
v4l2::RawFrameTaker shareFrames(const runtime::RuntimeFiles& files,
                                const std::function<void(const std::string&)>& log) {
  struct stat exchange {};
  if (::stat(files.exchange.c_str(), &exchange) != 0) return {};  // the daemon has just ended
  try {
    auto writer = std::make_shared<shared_picture::Writer>(
        shared_picture::WindowFiles{files.pictures, files.pictures_asked}, exchange.st_gid);
    return [writer = std::move(writer)](const pixels::YuyvImage& image, std::uint64_t sequence, Nanos time) {
      (void)writer->put(image, sequence, time, v4l2::monotonicNow());
    };
  } catch (const std::runtime_error& error) {
    if (log) log(std::string{messages::kNoPicturesForObservers} + error.what());
    return {};
  }
}

}  // namespace

std::unique_ptr<FrameSource> openLocalCamera(const CameraRequest& request) {
  v4l2::CameraOptions options;
  if (const RobotFile file = readRobotFile(); file.camera) options.device = *file.camera;
  options.width = request.width;
  options.height = request.height;
  options.settings = request.settings;
  options.form = request.form;
  options.log = request.log;
  if (request.observers) options.on_raw_frame = shareFrames(*request.observers, request.log);
  return std::make_unique<v4l2::Camera>(std::move(options));
}

std::unique_ptr<FrameSource> openCamera(runtime::RobotLink& robot, const CameraRequest& request) {
  if (auto its_own = robot.openCamera(request.width, request.height)) return its_own;
  // A camera of this computer does not show the simulated world.
  if (!robot.realTime()) throw std::runtime_error("this virtual robot has no camera: the twin has one, --robot twin");
  CameraRequest seen = request;
  if (const auto* const daemon = dynamic_cast<const runtime::DaemonLink*>(&robot)) seen.observers = daemon->files();
  return openLocalCamera(seen);
}

}  // namespace darwinop::connect
