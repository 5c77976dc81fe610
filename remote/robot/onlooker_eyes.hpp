// The robot's eyes for who only looks on: its camera while nobody drives, what the driver's camera sees otherwise.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "hal/frame_source.hpp"
#include "remote/picture_source.hpp"
#include "runtime/names.hpp"

namespace darwinop::remote {

/// Told of each new picture before it can be asked for, by a thread of its own. It must not throw.
using FrameLooker = std::function<void(const CameraFrame&)>;
using Teller = std::function<void(const std::string&)>;

/// As JPEG what `camera` sees, which is of kWholeImage and best gives YUYV.
std::unique_ptr<PictureSource> openPicturesOfCamera(std::unique_ptr<FrameSource> camera, const FrameLooker& look_at,
                                                    const Teller& say);

/// What the camera of whoever drives sees; never touches a camera. `say` may be told the same again by the next one.
/// Throws std::runtime_error when there is no runtime.
std::unique_ptr<PictureSource> openPicturesOfDriver(const runtime::RuntimeFiles& files, const FrameLooker& look_at,
                                                    const Teller& say);

}  // namespace darwinop::remote
