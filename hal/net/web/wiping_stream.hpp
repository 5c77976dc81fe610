// TCP stream that wipes its read buffers, so that no password stays in memory.
#pragma once

#include <string.h>

#include <boost/asio/buffer.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <utility>

namespace darwinop::web {

/// Beast's WebSocket keeps the last message, possibly a password, in an internal read buffer until the next one
/// arrives. The buffer passed to a read holds no live data, so it is wiped when the next read begins.
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

/// Customization point that Beast's WebSocket calls to end a connection.
// NOLINTBEGIN(readability-identifier-naming)
template <class Handler>
void async_teardown(boost::beast::role_type role, WipingStream& stream, Handler&& handler) {
  async_teardown(role, static_cast<boost::beast::tcp_stream&>(stream), std::forward<Handler>(handler));
}
// NOLINTEND(readability-identifier-naming)

}  // namespace darwinop::web
