// A TCP stream that leaves nothing of earlier messages in the buffers that it reads into.
#pragma once

#include <string.h>

#include <boost/asio/buffer.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <utility>

namespace darwinop::web {

/// Beast's WebSocket reads into a buffer of its own, where a message stays until the next one comes: it may have been a
/// password. What a reader offers to read into is free, so it is overwritten as soon as the next message is waited for.
class WipingStream : public boost::beast::tcp_stream {
 public:
  using boost::beast::tcp_stream::tcp_stream;

  template <class Buffers, class Handler>
  auto async_read_some(const Buffers& buffers, Handler&& handler) {
    const auto end = boost::asio::buffer_sequence_end(buffers);
    for (auto part = boost::asio::buffer_sequence_begin(buffers); part != end; ++part) {
      const boost::asio::mutable_buffer bytes{*part};
      explicit_bzero(bytes.data(), bytes.size());
    }
    return boost::beast::tcp_stream::async_read_some(buffers, std::forward<Handler>(handler));
  }
};

/// Beast's WebSocket ends a connection with this, and the name is Beast's.
// NOLINTBEGIN(readability-identifier-naming)
template <class Handler>
void async_teardown(boost::beast::role_type role, WipingStream& stream, Handler&& handler) {
  async_teardown(role, static_cast<boost::beast::tcp_stream&>(stream), std::forward<Handler>(handler));
}
// NOLINTEND(readability-identifier-naming)

}  // namespace darwinop::web
