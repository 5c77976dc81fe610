// Renders the head camera's view, or a test pattern without OpenGL.
#include "twin/render/head_camera.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <utility>

#include "twin/body/robot_body.hpp"
#include "twin/render/egl.hpp"
#include "twin/render/offscreen.hpp"
#include "twin/render/test_pattern.hpp"

namespace darwinop::twin {
namespace {

Nanos clockOf(const RobotBody& body) {
  return std::chrono::round<Nanos>(std::chrono::duration<double>(body.time_s()));
}

void logOnce(const std::string& reason) {
  static std::atomic<bool> logged{false};
  if (!logged.exchange(true)) std::fprintf(stderr, "twin: the head camera shows a test pattern: %s\n", reason.c_str());
}

}  // namespace

HeadCamera::HeadCamera(RobotBody& body, const Options& options)
    : body_{body}, options_{options}, model_{mj_copyModel(nullptr, body.mujocoModel())} {
  Offscreen::checkSize(options.width, options.height);
  bgra_.resize(4 * static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height));
}

HeadCamera::~HeadCamera() = default;

void HeadCamera::look() noexcept {
  const Nanos now = clockOf(body_);
  // Pictures are taken on a grid of periods: with calls every 16 ms and a period of 33 ms the rate is still 30/s.
  const auto slot = [this](Nanos time) { return time / options_.period; };
  if (sequence_ != 0 && slot(now) == slot(taken_)) return;
  pose_ = poseOf(body_);
  looked_ = true;
  sequence_ += sequence_ == 0 ? 1 : static_cast<std::uint64_t>(std::max<std::int64_t>(slot(now) - slot(taken_), 1));
  taken_ = now;
}

void HeadCamera::openGraphics() {
  const MjModelPtr model = std::move(model_);
  offscreen_ = std::make_unique<Offscreen>(*model, options_.width, options_.height, Quality::kEye);
  offscreen_->scene().lookFrom(Viewpoint::kHead);
}

void HeadCamera::draw() {
  try {
    if (model_) openGraphics();
    if (offscreen_) {
      offscreen_->scene().show(pose_);
      picture_ = offscreen_->draw();
    }
  } catch (const std::exception& failure) {  // the calling controller does not expect exceptions
    offscreen_.reset();
    render_error_ = failure.what();
    logOnce(render_error_);
  }
  if (!offscreen_)
    picture_ = testPattern(options_.width, options_.height, render_error_, static_cast<unsigned>(sequence_));
  const std::uint8_t* rgb = picture_.rgb.data();
  for (std::size_t i = 0; i < bgra_.size(); i += 4, rgb += 3) {
    bgra_[i] = rgb[2];
    bgra_[i + 1] = rgb[1];
    bgra_[i + 2] = rgb[0];
    bgra_[i + 3] = 255;
  }
}

CameraFrame HeadCamera::newest() {
  if (looked_) {
    draw();
    looked_ = false;
    ++pictures_;
  }
  return {sequence_, taken_, options_.width, options_.height, bgra_};
}

}  // namespace darwinop::twin
