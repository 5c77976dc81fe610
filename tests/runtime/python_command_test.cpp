// Python controllers of `darwinop run`: which interpreter, and what is refused.
#include "runtime/python_command.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "environment.hpp"
#include "runtime/controller_run.hpp"
#include "runtime/messages.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::runtime {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A folder with an extension for Python 3.19, and programs that behave as interpreters.
class PythonCommand : public testing::Test {
 protected:
  PythonCommand() {
    std::ofstream{folder_ / "_darwinop.cpython-319-x86_64-linux-gnu.so"} << "none";
    setenv("PATH", ((folder_ / "") + ":" + path_).c_str(), 1);
  }
  ~PythonCommand() override { setenv("PATH", path_.c_str(), 1); }

  /// A program that loads the modules if PYTHONPATH begins with their folder.
  void addInterpreter(const std::string& name, bool loads) const {
    const std::string path = folder_ / name;
    std::ofstream{path} << "#!/bin/sh\n"
                        << (loads ? "case $PYTHONPATH in \"" + modules() + "\"*) ;; *) exit 1;; esac" : "exit 1");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  }
  [[nodiscard]] std::string modules() const { return folder_ / "."; }
  [[nodiscard]] std::string found() const {
    try {
      return findPython(modules());
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  }

  const TemporaryFolder folder_;
  const std::string path_ = std::getenv("PATH");
};

TEST_F(PythonCommand, TheFirstInterpreterThatLoadsTheModulesIsTaken) {
  addInterpreter("python3", true);
  addInterpreter("python3.19", true);
  EXPECT_EQ(found(), "python3");
}

TEST_F(PythonCommand, AnotherVersionInFrontOfThePathIsPassedOver) {
  addInterpreter("python3", false);
  addInterpreter("python3.19", true);
  EXPECT_EQ(found(), "python3.19");
}

TEST_F(PythonCommand, TheOneThatTheUserNamesIsTheOnlyOneTried) {
  addInterpreter("python3", true);
  addInterpreter("mine", false);
  const Environment chosen{"DARWINOP_PYTHON_PROGRAM", folder_ / "mine"};
  EXPECT_THAT(found(),
              AllOf(StartsWith(messages::kNoPython + modules()), HasSubstr("3.19"), HasSubstr(folder_ / "mine")));
}

TEST_F(PythonCommand, AnEmptyNameIsNone) {
  addInterpreter("python3", true);
  const Environment chosen{"DARWINOP_PYTHON_PROGRAM", ""};
  EXPECT_EQ(found(), "python3");
}

TEST_F(PythonCommand, WithoutInterpreterThoseTriedAreNamed) {
  addInterpreter("python3", false);
  EXPECT_THAT(found(), AllOf(StartsWith(messages::kNoPython), HasSubstr("python3, python3.19, /usr/bin/python3.19")));
}

TEST_F(PythonCommand, ABuildWithoutModulesNamesTheirFolder) {
  std::filesystem::remove(folder_ / "_darwinop.cpython-319-x86_64-linux-gnu.so");
  EXPECT_THAT(found(), StartsWith(messages::kNoPythonModules + modules()));
}

TEST_F(PythonCommand, TheModulesComeBeforeWhatTheUserHas) {
  EXPECT_EQ(pythonPath("/modules"), "PYTHONPATH=/modules");
  {
    const Environment none{"PYTHONPATH", ""};  // an empty element would mean the current folder
    EXPECT_EQ(pythonPath("/modules"), "PYTHONPATH=/modules");
  }
  const Environment others{"PYTHONPATH", "/others"};
  EXPECT_EQ(pythonPath("/modules"), "PYTHONPATH=/modules:/others");
}

TEST_F(PythonCommand, AScriptNeedsNoRightToBeRunAndIsFoundByItsFolder) {
  std::filesystem::create_directory(folder_ / "walk");
  std::ofstream{folder_ / "walk/walk.py"} << "pass\n";
  EXPECT_EQ(controllerProgram(folder_ / "walk/walk.py"), folder_ / "walk/walk.py");
  EXPECT_EQ(controllerProgram(folder_ / "walk"), folder_ / "walk/walk.py");
  std::filesystem::create_symlink("/bin/true", folder_ / "walk/walk");
  EXPECT_EQ(controllerProgram(folder_ / "walk"), folder_ / "walk/walk") << "the built one, as ever";
}

}  // namespace
}  // namespace darwinop::runtime
