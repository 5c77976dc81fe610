// The controller's side of an exchange: what all kinds of robot link have in common.
#pragma once

#include <string>

#include "runtime/exchange.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::runtime {

class ExchangeLink : public RobotLink {
 public:
  [[nodiscard]] Nanos period() const override { return Nanos{block().info.period_ns}; }
  void publish(Commands commands) override;
  [[nodiscard]] Sensors sensors() const override;
  [[nodiscard]] std::string whyEnded() const override { return why_ended_; }

  /// Gives whoever drives from now on a number of their own, so that safety starts them gently. Only the holder of the
  /// driving lease may do this; a link has done it once when it is made.
  void beginSession();

 protected:
  explicit ExchangeLink(Exchange exchange) : exchange_{std::move(exchange)} {}

  [[nodiscard]] ExchangeBlock& block() const { return exchange_.block(); }
  /// Publishes the last image once more, saying farewell. False: this controller never drove, so there is nothing to
  /// bring to rest.
  bool sayFarewell();
  /// True when this session was ended by `darwinop runtime --release`.
  [[nodiscard]] bool releasedByOperator() const;
  [[nodiscard]] bool finished(std::uint64_t cycle) const;
  /// Notes why the robot is gone; always false.
  bool end(const std::string& why);

 private:
  Exchange exchange_;
  Commands last_{};
  mutable Sensors sensors_{};  // kept when nothing new can be read
  std::uint32_t session_ = 0;
  std::uint64_t sequence_ = 0;
  std::string why_ended_;
};

/// Sentence for a controller that was asked to end.
inline constexpr const char* kAskedToStop = "the controller was asked to stop";

}  // namespace darwinop::runtime
