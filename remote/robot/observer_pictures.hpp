// Camera pictures for observers: of the camera itself, or of the frames that the driving controller shares.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hal/frame_source.hpp"
#include "remote/picture_source.hpp"
#include "runtime/names.hpp"

namespace darwinop::remote {

/// Called from the encoder thread with each new frame before its picture is published. Must not throw.
using FrameCallback = std::function<void(const CameraFrame&)>;
using LogCallback = std::function<void(const std::string&)>;

/// Encodes the frames of `camera`, which must have the size kWholeImage; YUYV is cheapest.
std::unique_ptr<PictureSource> openPicturesOfCamera(std::unique_ptr<FrameSource> camera, const FrameCallback& on_frame,
                                                    const LogCallback& log);

/// Encodes the frames that the driving controller shares; never opens a camera device. `log` may get a message again
/// for the next controller. Throws std::runtime_error if no runtime is running.
std::unique_ptr<PictureSource> openPicturesOfDriver(const runtime::RuntimeFiles& files, const FrameCallback& on_frame,
                                                    const LogCallback& log);

}  // namespace darwinop::remote
