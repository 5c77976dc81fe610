// Reply of the remote-control protocol: values in the order of the request, without tags.
#include "remote/protocol/reply.hpp"

#include "remote/protocol/sensor_block.hpp"

namespace darwinop::remote {
namespace {

void addWord(std::vector<std::uint8_t>& bytes, std::int32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> shift));
}

std::size_t extensionSize(const ReplyExtension& extension) {
  return kExtensionFigures + (extension.seen != nullptr ? kSensorBlock : 0) + extension.why_ended.size();
}

void addExtension(std::vector<std::uint8_t>& bytes, const ReplyExtension& extension) {
  bytes.push_back(kExtensionTag);
  bytes.push_back(kExtensionVersion);
  addWord(bytes, static_cast<std::int32_t>(extensionSize(extension)));
  bytes.push_back(static_cast<std::uint8_t>((extension.real_time ? 1 : 0) | (extension.seen != nullptr ? 2 : 0) |
                                            (extension.holds_picture ? 4 : 0)));
  addWord(bytes, static_cast<std::int32_t>(extension.held_us));
  addWord(bytes, static_cast<std::int32_t>(extension.picture));
  addWord(bytes, static_cast<std::int32_t>(extension.picture_age_us));
  if (extension.seen != nullptr) writeSensors(*extension.seen, bytes);
  bytes.insert(bytes.end(), extension.why_ended.begin(), extension.why_ended.end());
}

}  // namespace

void writeReply(const Request& request, const Reply& reply, std::vector<std::uint8_t>& bytes) {
  bytes.clear();
  bytes.push_back(kFirstByte);
  const std::size_t axes = 12 * (std::size_t{request.accelerometer} + std::size_t{request.gyro});
  const std::size_t picture = request.camera ? 4 + reply.jpeg.size() : 0;
  const std::size_t words = 4 * (reply.positions.size() + reply.torques.size());
  const bool extended = request.extended && reply.extension;
  const std::size_t more = extended ? kExtensionHead + extensionSize(*reply.extension) : 0;
  addWord(bytes, static_cast<std::int32_t>(kReplyHead + axes + picture + words + more));
  if (request.accelerometer)
    for (const std::int32_t axis : reply.accelerometer) addWord(bytes, axis);
  if (request.gyro)
    for (const std::int32_t axis : reply.gyro) addWord(bytes, axis);
  if (request.camera) {
    addWord(bytes, static_cast<std::int32_t>(reply.jpeg.size()));
    bytes.insert(bytes.end(), reply.jpeg.begin(), reply.jpeg.end());
  }
  for (const std::int32_t position : reply.positions) addWord(bytes, position);
  for (const std::int32_t torque : reply.torques) addWord(bytes, torque);
  if (extended) addExtension(bytes, *reply.extension);
  bytes.push_back(0);
}

}  // namespace darwinop::remote
