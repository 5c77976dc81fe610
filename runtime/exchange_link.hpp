// The controller's side of an exchange: what all kinds of robot link have in common.
#pragma once

#include <string>

#include "runtime/exchange.hpp"
#include "runtime/robot_link.hpp"
#include "safety/config.hpp"

namespace darwinop::runtime {

class ExchangeLink : public RobotLink {
 public:
  [[nodiscard]] Nanos period() const override { return Nanos{info_.period_ns}; }
  void publish(Commands commands) override;
  [[nodiscard]] Sensors sensors() const override;
  [[nodiscard]] std::string whyEnded() const override { return why_ended_; }

  /// Gives the next driver a new number, so that safety starts it gently. Only the holder of the
  /// driving lease may do this; a link has done it once when it is made.
  void beginSession();
  /// The robot's [Safety] and [Limits], as published by the loop when the session began.
  [[nodiscard]] safety::Config robotSafety() const;
  /// What this session asks for besides. Before the first image.
  void setSafety(const safety::Config& config);

 protected:
  explicit ExchangeLink(Exchange exchange);

  [[nodiscard]] const ExchangeBlock& block() const { return exchange_.block(); }
  [[nodiscard]] const Exchange& exchange() const { return exchange_; }
  [[nodiscard]] const LoopInfo& info() const { return info_; }
  /// Sleeps until a cycle after the one of this number is finished, a signal comes, or `at_most` is over.
  void sleepUntilAfter(std::uint32_t finished, Nanos at_most) const;
  /// Publishes the last image once more, as end of session. False: this controller never drove, so there is nothing to
  /// bring to rest.
  bool publishEndOfSession();
  /// True when `darwinop runtime --release` ended this session.
  [[nodiscard]] bool releasedByOperator() const;
  [[nodiscard]] bool finished(std::uint64_t cycle) const;
  /// Notes why the robot is gone; always false.
  bool end(const std::string& why);

 private:
  Exchange exchange_;
  LoopInfo info_{};  // a copy: the memory may be lost
  Commands last_{};
  SessionSettings settings_{};
  mutable Sensors sensors_{};  // kept when nothing new can be read
  std::uint32_t session_ = 0;
  std::uint64_t sequence_ = 0;
  bool unattended_;
  std::string why_ended_;
};

/// Sentence for a controller that was asked to end.
inline constexpr const char* kAskedToStop = "the controller was asked to stop";

}  // namespace darwinop::runtime
