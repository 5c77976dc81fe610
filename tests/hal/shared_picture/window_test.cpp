// A writer and readers of one shared picture file, each with its own mapping, as in separate processes.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <thread>

#include "hal/shared_picture/reader.hpp"
#include "hal/shared_picture/writer.hpp"
#include "support/temporary_folder.hpp"
#include "support/text_of.hpp"

namespace darwinop::shared_picture {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

/// Raw access, to leave the file as a malicious or dead process might.
class RawWindow {
 public:
  explicit RawWindow(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDWR);
    memory_ = ::mmap(nullptr, sizeof(SharedWindow), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
  }
  ~RawWindow() { ::munmap(memory_, sizeof(SharedWindow)); }
  RawWindow(const RawWindow&) = delete;
  RawWindow& operator=(const RawWindow&) = delete;
  SharedWindow* operator->() { return static_cast<SharedWindow*>(memory_); }
  SharedWindow& operator*() { return *static_cast<SharedWindow*>(memory_); }

 private:
  void* memory_;
};

class SharedPicture : public testing::Test {
 protected:
  void makeWriter() { writer_.emplace(files_, ::getegid()); }
  Reader& reader() {
    if (!reader_)
      reader_ =
          std::make_unique<Reader>(Reader::Options{.files = files_,
                                                   .group = ::getegid(),
                                                   .now = [this] { return now_; },
                                                   .log = [this](const auto& text) { messages_.push_back(text); }});
    return *reader_;
  }
  /// A single colour, so that a mixture of two pictures is visible.
  bool put(std::uint64_t sequence, int width = kWidth) {
    std::ranges::fill(raw_, static_cast<std::uint8_t>(sequence));
    return writer_->put({raw_, width, kHeight, kStride}, sequence, now_, now_);
  }
  void lookAgain() {
    now_ += 1s;
    (void)reader().newest();
  }

  static constexpr std::size_t kStride = 2 * kWidth + 8;
  TemporaryFolder folder_;
  WindowFiles files_{folder_ / "pictures", folder_ / "asked"};
  Nanos now_{1h};
  std::vector<std::uint8_t> raw_ = std::vector<std::uint8_t>(kStride * kHeight);
  std::vector<std::string> messages_;
  std::optional<Writer> writer_;
  std::unique_ptr<Reader> reader_;
};

TEST_F(SharedPicture, IsCopiedOnlyOnRequest) {
  makeWriter();
  EXPECT_FALSE(put(1)) << "no request";
  EXPECT_EQ(reader().newest().sequence, 0u);
  EXPECT_TRUE(put(2));
  const CameraFrame frame = reader().newest();
  EXPECT_EQ(frame.sequence, 2u);
  EXPECT_EQ(frame.time, now_);
  EXPECT_EQ(frame.yuyv.size(), kPictureBytes);
  EXPECT_TRUE(std::ranges::all_of(frame.yuyv, [](auto byte) { return byte == 2; }));
  EXPECT_TRUE(reader().health().seeing);
  now_ += kAsked;
  EXPECT_FALSE(put(3)) << "the reader has stopped";
  EXPECT_FALSE(reader().health().seeing);
  EXPECT_THAT(messages_, ElementsAre());
}

TEST_F(SharedPicture, IsIgnoredWhenItIsTooOld) {
  makeWriter();
  (void)reader().newest();
  ASSERT_TRUE(put(1));
  now_ += kFresh;
  EXPECT_EQ(reader().newest().sequence, 0u);
  for (int i = 0; i < 10; ++i) lookAgain();
  EXPECT_THAT(messages_, ElementsAre(HasSubstr(kNoNewPictures))) << "once";
}

TEST_F(SharedPicture, IsThePreviousOneWhenTheWriterDiesInTheMiddle) {
  makeWriter();
  (void)reader().newest();
  ASSERT_TRUE(put(1));
  RawWindow raw{files_.pictures};
  raw->slots[1].turn = 1;  // where the second picture was started
  EXPECT_EQ(reader().newest().sequence, 1u);
  raw->newest = 2;  // must not be used although `newest` points there
  raw->slots[1].sequence = 2;
  raw->slots[1].time_ns = now_.count();
  EXPECT_EQ(reader().newest().sequence, 1u);
  raw->newest = 1U << 20;
  EXPECT_EQ(reader().newest().sequence, 1u);
}

/// Writes a slot as a Writer does, but always the same one, to overtake the reader.
void overtake(SharedWindow& window, std::uint64_t sequence, const std::vector<std::uint8_t>& bytes) {
  Slot& slot = window.slots[0];
  const std::uint32_t turn = slot.turn.exchange(slot.turn + 1, std::memory_order_acq_rel);
  slot.sequence = sequence;
  slot.time_ns = Nanos{1h}.count();
  std::memcpy(slot.bytes.data(), bytes.data(), kPictureBytes);
  slot.turn.store(turn + 2, std::memory_order_release);
  window.newest.store(1, std::memory_order_release);
}

TEST_F(SharedPicture, IsNeverAMixtureOfTwoPictures) {
  makeWriter();
  (void)reader().newest();
  const std::array<std::vector<std::uint8_t>, 2> pictures{std::vector<std::uint8_t>(kPictureBytes, 0),
                                                          std::vector<std::uint8_t>(kPictureBytes, 1)};
  std::atomic<bool> stop{false};
  std::thread other{[&] {
    RawWindow window{files_.pictures};
    for (std::uint64_t sequence = 1; !stop; ++sequence) {
      if (sequence % 64 < 32)
        overtake(*window, sequence, pictures[sequence % 2]);
      else
        (void)writer_->put({pictures[sequence % 2], kWidth, kHeight, 2 * kWidth}, sequence, Nanos{1h}, Nanos{1h});
    }
  }};
  std::uint64_t last = 0;
  bool whole = true;
  for (int seen = 0; seen < 300 && whole;) {
    const CameraFrame frame = reader().newest();
    if (frame.sequence == last) continue;
    ++seen;
    last = frame.sequence;
    whole = std::memcmp(frame.yuyv.data(), pictures[last % 2].data(), kPictureBytes) == 0;
    EXPECT_TRUE(whole) << "picture " << last;
  }
  stop = true;
  other.join();
}

TEST_F(SharedPicture, OfATruncatedFileEndsNeitherWriterNorReader) {
  makeWriter();
  lookAgain();
  ASSERT_TRUE(put(1));
  lookAgain();
  ASSERT_EQ(::truncate(files_.pictures.c_str(), 0), 0);
  for (std::uint64_t sequence = 2; sequence < 9; ++sequence) {
    (void)put(sequence);
    lookAgain();
  }
  EXPECT_FALSE(reader().health().seeing);
}

TEST_F(SharedPicture, IsFoundAgainWhenItsWriterIsReplaced) {
  EXPECT_EQ(reader().newest().sequence, 0u) << "no picture yet";
  makeWriter();
  lookAgain();
  ASSERT_TRUE(put(7));
  EXPECT_EQ(reader().newest().sequence, 7u);
  const Writer second{files_, ::getegid()};  // replaces the first writer, which must not remove the new files
  writer_.reset();
  EXPECT_TRUE(std::filesystem::exists(files_.pictures));
  makeWriter();
  lookAgain();
  ASSERT_TRUE(put(7));
  EXPECT_EQ(reader().newest().time, now_);
  writer_.reset();
  EXPECT_FALSE(std::filesystem::exists(files_.pictures));
  EXPECT_FALSE(std::filesystem::exists(files_.asked));
  lookAgain();
  EXPECT_THAT(messages_, ElementsAre());
}

TEST_F(SharedPicture, OfAnotherSizeIsReported) {
  makeWriter();
  (void)reader().newest();
  EXPECT_FALSE(put(1, kWidth / 2));
  for (int i = 0; i < 3; ++i) lookAgain();
  EXPECT_THAT(messages_, ElementsAre(HasSubstr("160x240")));
}

TEST_F(SharedPicture, IsIgnoredWhenItsFileHasAnotherVersion) {
  makeWriter();
  RawWindow {
    files_.pictures
    } -> layout = SharedWindow::kLayout + 1;
  for (int i = 0; i < 3; ++i) lookAgain();
  EXPECT_THAT(messages_, ElementsAre(HasSubstr(kOtherVersion)));
  EXPECT_FALSE(put(1)) << "no request either";

  RawWindow {
    files_.pictures
    } -> layout = SharedWindow::kLayout;
  std::filesystem::resize_file(files_.pictures, sizeof(SharedWindow) - 1);
  reader_.reset();
  lookAgain();
  EXPECT_THAT(messages_.back(), HasSubstr(kOtherVersion));
  EXPECT_EQ(messages_.size(), 2u);
  std::filesystem::resize_file(files_.pictures, sizeof(SharedWindow));
  lookAgain();
  EXPECT_TRUE(put(2)) << "valid again";
}

TEST_F(SharedPicture, IsIgnoredWhenItsFileHasASecondNameOrEveryUserMayWriteIt) {
  makeWriter();
  ASSERT_EQ(::chmod(files_.pictures.c_str(), 0666), 0);
  lookAgain();
  put(1);
  lookAgain();
  EXPECT_FALSE(reader().health().seeing);
  EXPECT_THAT(messages_, ElementsAre(HasSubstr(kNotAPlainFile)));
  ASSERT_EQ(::chmod(files_.pictures.c_str(), 0640), 0);
  std::filesystem::create_hard_link(files_.pictures, folder_ / "second");
  lookAgain();
  put(2);
  lookAgain();
  EXPECT_FALSE(reader().health().seeing);
}

TEST_F(SharedPicture, IsNotRequestedThroughAFileOfSomebodyElse) {
  makeWriter();
  std::ofstream{folder_ / "precious"} << "precious";
  std::filesystem::remove(files_.asked);
  std::filesystem::create_hard_link(folder_ / "precious", files_.asked);
  lookAgain();
  EXPECT_THAT(messages_, ElementsAre(HasSubstr(files_.asked)));
  std::filesystem::remove(files_.asked);
  ASSERT_EQ(::mkfifo(files_.asked.c_str(), 0666), 0);
  const int blocked_reader = ::open(files_.asked.c_str(), O_RDONLY | O_NONBLOCK);
  lookAgain();
  ::close(blocked_reader);
  std::filesystem::remove(files_.asked);
  std::filesystem::create_symlink(folder_ / "precious", files_.asked);
  lookAgain();
  EXPECT_EQ(textOf(folder_ / "precious"), "precious");
}

TEST_F(SharedPicture, CannotBeModifiedByObservers) {
  makeWriter();
  struct stat pictures {
  }, asked{};
  ASSERT_EQ(::stat(files_.pictures.c_str(), &pictures), 0);
  ASSERT_EQ(::stat(files_.asked.c_str(), &asked), 0);
  EXPECT_EQ(pictures.st_mode & 0777, 0640u);
  EXPECT_EQ(asked.st_mode & 0777, 0660u);
  (void)reader().newest();
  ASSERT_TRUE(put(1));
  std::filesystem::resize_file(files_.asked, 3);
  EXPECT_FALSE(put(2));
  std::ofstream{files_.asked} << "\x7F\xFF\xFF\xFF\xFF\xFF\xFF\x7F";
  EXPECT_FALSE(put(3)) << "a time in the future";
  lookAgain();
  EXPECT_TRUE(put(4)) << "a valid request";
}

TEST_F(SharedPicture, ReportsARemedyWhenItCannotBeCreated) {
  const WindowFiles nowhere{folder_ / "none/pictures", folder_ / "none/asked"};
  try {
    const Writer writer{nowhere, ::getegid()};
    FAIL() << "the folder does not exist";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("writable"));
  }
  std::filesystem::create_directory(files_.pictures);  // cannot be replaced by a file
  EXPECT_THROW(makeWriter(), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(files_.asked)) << "no file is left";
}

}  // namespace
}  // namespace darwinop::shared_picture
