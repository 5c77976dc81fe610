// Between the page's words and the thread that drives: what is wanted, what becomes of it.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>

#include "core/joints.hpp"
#include "core/units.hpp"
#include "managers/gait/stride.hpp"

namespace darwinop::window {

inline constexpr std::size_t kLimbs = 5;  // a limb is a daisy chain: both arms, head, both legs

/// `walk` holds until it is said otherwise; everything else is asked for once.
struct Orders {
  std::array<std::optional<Rad>, kJoints> goals{};
  std::optional<gait::WalkCommand> walk{};           // nothing: stand
  int page = 0;                                      // to play from now on; 0: none
  std::array<std::optional<bool>, kLimbs> torque{};  // by Chain; false: the limb is limp

  /// What is newer counts.
  void add(const Orders& newer);
  /// They are passed on: only what holds remains.
  void taken() { *this = {.walk = walk}; }
};

/// What the robot does because of it.
struct Doings {
  bool walks = false;
  int page = 0;                // that is being played; 0: none
  std::bitset<kLimbs> limp{};  // by Chain, as ordered
  std::string refused{};       // why the last order was not followed; empty: it was
  bool operator==(const Doings&) const = default;
};

/// One thread asks, none of this waits.
class Helm {
 public:
  enum class State : std::uint8_t { kFree, kAsking, kDriving, kEnding };
  struct Report {
    State state = State::kFree;
    std::string why{};  // kFree: why the last one ended, or did not begin; empty: as ordered
    Doings doings{};
  };

  virtual ~Helm() = default;
  /// Only when free.
  virtual void begin() = 0;
  /// While it drives: heard from, and what is wanted.
  virtual void order(const Orders& orders) = 0;
  /// At once, wherever the joints are.
  virtual void stop() = 0;
  /// As soon as steps under way are walked to their end: nobody is there any more.
  virtual void leave() = 0;
  [[nodiscard]] virtual Report report() = 0;
};

}  // namespace darwinop::window
