// Time, wire, power and faults of the virtual CM-730.
#include "hil-mocks/virtual_board.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "hil-mocks/fault.hpp"

namespace darwinop::hil {

VirtualBoard::VirtualBoard(const BoardOptions& options, Body& body)
    : options_{options},
      body_{body},
      device_{options.model, options.firmware},
      supply_v_{options.supply_v},
      rail_v_{supply_v_} {
  boot_.fill(options.servo_boot);
  servos_.reserve(kJoints);
  for (std::size_t i = 0; i < kJoints; ++i) {
    servos_.emplace_back(static_cast<Joint>(i), options.servo[i]);
    servos_[i].setUsualTemperature(options.temperature_c);
    servos_[i].setSupply(options.supply_v);
    servos_[i].measure(body_.state().joint[i]);
  }
  device_.setServoPower(options.servo_power || !options.board);
  afterBoardWrite();
}

void VirtualBoard::receive(Bytes bytes, Nanos when) noexcept {
  input_.push(bytes, std::max(when, now_));
  counters_.lost_bytes = input_.lost();
}

std::optional<Nanos> VirtualBoard::nextEvent() const noexcept {
  if (stalled_until_ == Nanos::max()) return std::nullopt;
  if (turn_ < turn_count_) return std::max(free(), now_);
  if (input_.empty()) return std::nullopt;
  return std::max({input_.when(), free(), now_}) + options_.byte_time;
}

std::optional<Nanos> VirtualBoard::earliestReply() const noexcept {
  const std::optional<Nanos> next = nextEvent();
  if (!next || turn_ < turn_count_) return next;
  return *next + options_.byte_time * static_cast<std::int64_t>(parser_.missing() - 1);
}

void VirtualBoard::advance(Nanos until, bool stop_at_reply) noexcept {
  while (true) {
    const std::optional<Nanos> next = nextEvent();
    if (!next || *next > until) break;
    stepBody(*next);
    now_ = *next;
    if (turn_ < turn_count_) {
      nextTurn();
    } else {
      takeByte();
    }
    if (stop_at_reply && !output_.empty()) return;
  }
  if (until > now_) {
    stepBody(until);
    now_ = until;
  }
}

void VirtualBoard::stepBody(Nanos until) noexcept {
  while (body_time_ + options_.body_step <= until) {
    supplyServos();
    for (std::size_t i = 0; i < kJoints; ++i) {
      servos_[i].strain(options_.body_step);
      drives_[i] = servos_[i].drive(body_.state().joint[i]);
    }
    body_.step(options_.body_step, drives_);
    if (body_.error() != nullptr && !silenced_) {
      silenced_ = true;
      std::fprintf(stderr, "darwinop: %s\n", body_.error());
    }
    body_time_ += options_.body_step;
  }
}

/// Servos are off while their supply is too low. One that gave way to their load recovers without it.
void VirtualBoard::supplyServos() noexcept {
  if (sag_v_ > 0) {
    double load = 0;
    for (std::size_t i = 0; i < kJoints; ++i)
      if (servos_[i].state().pulls()) load += std::abs(body_.state().joint[i].load) / kJoints;
    rail_v_ = std::max(0.0, supply_v_ - sag_v_ * load);
    for (VirtualServo& s : servos_) s.setSupply(rail_v_);
  }
  const bool was_out = std::exchange(brown_out_, rail_v_ - body_.state().battery_drop_v < kBrownOutV);
  if (brown_out_ != was_out) afterBoardWrite();
}

void VirtualBoard::takeByte() noexcept {
  const InstructionParser::Result result = parser_.take(input_.pop(), now_);
  line_free_ = now_;
  if (result == InstructionParser::Result::kMore) return;
  execute(result == InstructionParser::Result::kFrame);
}

void VirtualBoard::afterBoardWrite() noexcept {
  for (VirtualServo& s : servos_) {
    if (device_.servoPower() && !brown_out_) {
      measure(s);  // its goal becomes its present position
      s.powerUp(now_, boot_[static_cast<std::size_t>(&s - servos_.data())]);
    } else {
      s.powerDown();
    }
  }
}

void VirtualBoard::babble(Bytes bytes) noexcept {
  downlink_free_ = std::max(now_, downlink_free_) + options_.byte_time * static_cast<std::int64_t>(bytes.size());
  if (!output_.push(bytes, downlink_free_)) counters_.lost_bytes += bytes.size();
}

void VirtualBoard::observe(ServoObserver* observer) noexcept {
  for (VirtualServo& s : servos_) s.observe(observer);
}

void VirtualBoard::setServoDead(Joint joint, bool dead) noexcept {
  servoOf(joint).setDead(dead);
  afterBoardWrite();
}

void VirtualBoard::setSupply(double volt) noexcept {
  supply_v_ = rail_v_ = volt;
  for (VirtualServo& s : servos_) s.setSupply(volt);
}

void VirtualBoard::pressReset() noexcept {
  if (!options_.board) return;
  device_.restart();
  afterBoardWrite();
  parser_.clear();
  turn_ = turn_count_ = 0;
}

}  // namespace darwinop::hil
