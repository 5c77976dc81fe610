// Controller's side of an exchange: base class of the robot links.
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

  /// Begins a session with a new number, which safety starts gently. Only the holder of the driving lease may call
  /// this; the constructor has called it once.
  void beginSession() override;
  /// The robot's [Safety] and [Limits], as published by the loop when the session began.
  [[nodiscard]] safety::Config robotSafety() const;
  /// Stricter settings for this session. Call before the first publish().
  void setSafety(const safety::Config& config);

 protected:
  explicit ExchangeLink(Exchange exchange);

  [[nodiscard]] const ExchangeBlock& block() const { return exchange_.block(); }
  [[nodiscard]] const Exchange& exchange() const { return exchange_; }
  [[nodiscard]] const LoopInfo& info() const { return info_; }
  /// Sleeps until a cycle later than number `finished` is complete, a signal arrives, or `at_most` has passed.
  void sleepUntilAfter(std::uint32_t finished, Nanos at_most) const;
  /// Publishes the last image again, marked as end of session. False: this controller never drove, so the robot need
  /// not be brought to rest.
  bool publishEndOfSession();
  /// True when `darwinop runtime --release` ended this session.
  [[nodiscard]] bool releasedByOperator() const;
  [[nodiscard]] bool finished(std::uint64_t cycle) const;
  /// Stores the reason for whyEnded(); returns false.
  bool end(const std::string& why);

 private:
  Exchange exchange_;
  LoopInfo info_{};  // a copy: the memory may be lost
  Commands last_{};
  SessionSettings settings_{};
  mutable Sensors sensors_{};  // the previous image if no newer one is available
  std::uint32_t session_ = 0;
  std::uint64_t sequence_ = 0;
  bool unattended_;
  std::string why_ended_;
};

/// Message for a controller that was requested to end.
inline constexpr const char* kAskedToStop = "the controller was asked to stop";

}  // namespace darwinop::runtime
