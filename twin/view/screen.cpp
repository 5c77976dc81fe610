// Output of the view: a window, or a film.
#include "twin/view/screen.hpp"

#include <cmath>
#include <cstdint>
#include <iostream>
#include <limits>
#include <utility>

#include "twin/render/film.hpp"
#include "twin/render/offscreen.hpp"

namespace darwinop::twin {
namespace {

/// Shows the newest pose and skips older ones.
class LiveScreen final : public ViewOutput {
 public:
  LiveScreen(const ShowOptions& options, const mjModel_& model, WindowKeys keys)
      : seconds_{options.seconds},
        window_{model, options.width, options.height, "darwinop twin: " + options.model, std::move(keys)} {
    window_.scene().lookFrom(options.from);
  }

  [[nodiscard]] int posesPerSecond() const override { return 60; }
  bool draw(PoseRing& poses, const std::string& line) override {
    window_.pollEvents();
    bool newer = false;
    while (poses.pop(pose_)) newer = true;
    if (!newer) return false;
    window_.scene().show(pose_);
    window_.setLine(line);
    window_.draw();
    return true;
  }
  [[nodiscard]] bool isFinished() override { return window_.closed() || (seconds_ > 0 && pose_.time_s >= seconds_); }
  void finish(PoseRing&, const std::function<bool()>&) override {}

 private:
  double seconds_;
  Pose pose_;
  ViewWindow window_;
};

/// Draws every pose once.
class FilmScreen final : public ViewOutput {
 public:
  FilmScreen(const ShowOptions& options, const mjModel_& model)
      : per_second_{options.per_second}, offscreen_{model, options.width, options.height, Quality::kFilm} {
    if (options.seconds > 0) most_ = std::max<std::int64_t>(std::llround(options.seconds * per_second_), 1);
    offscreen_.scene().lookFrom(options.from);
    std::string note;
    film_ = makeFilm(options.record, options.width, options.height, per_second_, note);
    if (!note.empty()) std::cerr << "darwinop twin: " << note << '\n';
  }

  [[nodiscard]] int posesPerSecond() const override { return per_second_; }
  bool draw(PoseRing& poses, const std::string&) override {
    Pose pose;
    over_ = poses.offered() >= most_;
    if (count_ == most_ || !poses.pop(pose)) return false;
    offscreen_.scene().show(pose);
    film_->add(offscreen_.draw());
    ++count_;
    return true;
  }
  /// By the robot's clock, because drawing may lag behind.
  [[nodiscard]] bool isFinished() override { return over_; }
  void finish(PoseRing& poses, const std::function<bool()>& hurry) override {
    while (!hurry() && draw(poses, {})) {
    }
    film_->finish();
    std::cout << "film: " << film_->place() << ", " << count_ << " pictures, "
              << static_cast<double>(count_) / per_second_ << " s\n";
    if (poses.dropped() > 0)
      std::cerr << "darwinop twin: " << poses.dropped()
                << " pictures are missing because drawing was too slow; use a smaller --size or --fps\n";
  }

 private:
  int per_second_;
  bool over_ = false;
  std::int64_t count_ = 0, most_ = std::numeric_limits<std::int64_t>::max();
  Offscreen offscreen_;
  std::unique_ptr<Film> film_;
};

}  // namespace

std::unique_ptr<ViewOutput> makeScreen(const ShowOptions& options, const mjModel_& model, WindowKeys keys) {
  if (!options.record.empty()) return std::make_unique<FilmScreen>(options, model);
  try {
    return std::make_unique<LiveScreen>(options, model, std::move(keys));
  } catch (const NoDisplay& none) {
    throw NoDisplay(std::string{none.what()} + "; record a film instead: --record FILE.mp4 (or a folder for pictures)");
  }
}

}  // namespace darwinop::twin
