// A reply: values in the order in which they were asked for, without tags.
#include "remote/protocol/reply.hpp"

namespace darwinop::remote {
namespace {

void addWord(std::vector<std::uint8_t>& bytes, std::int32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> shift));
}

}  // namespace

void writeReply(const Request& request, const Reply& reply, std::vector<std::uint8_t>& bytes) {
  bytes.clear();
  bytes.push_back(kFirstByte);
  const std::size_t axes = 12 * (std::size_t{request.accelerometer} + std::size_t{request.gyro});
  const std::size_t picture = request.camera ? 4 + reply.jpeg.size() : 0;
  const std::size_t words = 4 * (reply.positions.size() + reply.torques.size());
  addWord(bytes, static_cast<std::int32_t>(kReplyHead + axes + picture + words));
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
  bytes.push_back(0);
}

}  // namespace darwinop::remote
