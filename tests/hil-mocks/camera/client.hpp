// A program that uses the camera as any would: V4L2 and nothing of ours.
#pragma once

#include <fcntl.h>
#include <linux/videodev2.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <string>
#include <vector>

#include "hil-mocks/camera/frame_painter.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::hil {

inline constexpr const char* kDevice = "/dev/video0";
inline constexpr int kPatienceMs = 2000;

/// A painter whose file the camera in this process reads.
struct Eyes {
  Eyes() : painter{folder / "frames"} { setenv("DARWINOP_VIRTUAL_CAMERA", painter.path().c_str(), 1); }
  ~Eyes() { unsetenv("DARWINOP_VIRTUAL_CAMERA"); }
  Eyes(const Eyes&) = delete;
  Eyes& operator=(const Eyes&) = delete;
  TemporaryFolder folder;
  FramePainter painter;
};

class Client {
 public:
  explicit Client(int flags = O_RDWR | O_NONBLOCK) : fd{open(kDevice, flags)} {}
  ~Client() {
    for (const Part& part : parts_) munmap(part.memory, part.length);
    if (fd >= 0) close(fd);
  }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// 0 or an errno, as all that follow.
  template <class T>
  int ask(unsigned long request, T& argument) const {
    return ioctl(fd, request, &argument) == 0 ? 0 : errno;
  }
  int setSize(unsigned width, unsigned height) {
    format = {};
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    format.fmt.pix.width = width;
    format.fmt.pix.height = height;
    format.fmt.pix.pixelformat = V4L2_PIX_FMT_YUYV;
    return ask(VIDIOC_S_FMT, format);
  }
  int requestBuffers(unsigned count) {
    buffers = {};
    buffers.count = count;
    buffers.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffers.memory = V4L2_MEMORY_MMAP;
    return ask(VIDIOC_REQBUFS, buffers);
  }
  static v4l2_buffer buffer(unsigned index = 0) {
    v4l2_buffer one = {};
    one.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    one.memory = V4L2_MEMORY_MMAP;
    one.index = index;
    return one;
  }
  int mapAndQueue() {
    for (unsigned i = 0; i < buffers.count; ++i) {
      v4l2_buffer one = buffer(i);
      if (const int error = ask(VIDIOC_QUERYBUF, one); error != 0) return error;
      void* const memory = mmap(nullptr, one.length, PROT_READ | PROT_WRITE, MAP_SHARED, fd, one.m.offset);
      if (memory == MAP_FAILED) return errno;
      parts_.push_back({static_cast<std::uint8_t*>(memory), one.length});
      if (const int error = ask(VIDIOC_QBUF, one); error != 0) return error;
    }
    return 0;
  }
  int stream(unsigned long request = VIDIOC_STREAMON) const {
    int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    return ask(request, type);
  }
  int begin(unsigned width, unsigned height, unsigned count = 4) {
    int error = setSize(width, height);
    if (error == 0) error = requestBuffers(count);
    if (error == 0) error = mapAndQueue();
    return error == 0 ? stream() : error;
  }
  [[nodiscard]] bool readable(int wait_ms = kPatienceMs) const {
    pollfd one{fd, POLLIN, 0};
    return poll(&one, 1, wait_ms) == 1;
  }
  /// Waits, takes a frame into `last` and queues its buffer again.
  int frame() {
    if (!readable()) return ETIMEDOUT;
    last = buffer();
    if (const int error = ask(VIDIOC_DQBUF, last); error != 0) return error;
    v4l2_buffer again = last;
    return ask(VIDIOC_QBUF, again);
  }
  [[nodiscard]] const std::uint8_t* pixels() const { return parts_[last.index].memory; }
  int control(std::uint32_t id, std::int32_t value) const {
    v4l2_control one = {id, value};
    return ask(VIDIOC_S_CTRL, one);
  }

  int fd;
  v4l2_format format = {};
  v4l2_requestbuffers buffers = {};
  v4l2_buffer last = {};

 private:
  struct Part {
    std::uint8_t* memory;
    std::size_t length;
  };
  std::vector<Part> parts_;
};

}  // namespace darwinop::hil
