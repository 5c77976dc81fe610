// The robot's eye for tests of the server.
#pragma once

#include <memory>

#include "remote/picture_source.hpp"
#include "remote/protocol/examples.hpp"
#include "remote/server/server.hpp"
#include "served.hpp"

namespace darwinop::remote {

/// The robot's eye, which always sees the same; counts how often it is opened, and whether it is open.
struct FixedEye {
  ByteList jpeg = fromHex("ff d8 ff e0 00 10 ff d9");
  int opened = 0, open = 0;

  struct Pictures final : PictureSource {
    FixedEye& eye;
    explicit Pictures(FixedEye& its_eye) : eye{its_eye} {
      ++eye.opened;
      ++eye.open;
    }
    ~Pictures() override { --eye.open; }
    JpegPicture newest() override { return {.sequence = 1, .jpeg = eye.jpeg}; }
  };
  [[nodiscard]] Server::OpenPictures opener() {
    return [this] { return std::make_unique<Pictures>(*this); };
  }
};

}  // namespace darwinop::remote
