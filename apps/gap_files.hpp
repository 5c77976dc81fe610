// Files that commands of darwinop-gap read and write, and where reports go.
#pragma once

#include <string>

#include "gap_commands.hpp"
#include "twin/model/copy_body.hpp"

namespace darwinop::gap {
namespace messages {
inline constexpr const char* kOutExists = " exists; give another folder with --out";
inline constexpr const char* kOtherCase =
    " is not the case that these logs make now, and may have been edited; run it with "
    "darwinop gap run ";
inline constexpr const char* kOtherReport = "; give another folder with --report";
inline constexpr const char* kNoReportFolder = " is not a folder; give another folder with --report";
inline constexpr const char* kNoPageOfBody =
    "report of a whole robot prints its figures and writes no page; leave out --report and --open";
inline constexpr const char* kModelOfReport = ", repaired.ini the model with the effects";
inline constexpr const char* kRecordingExists =
    " exists; --resume keeps the recordings there and makes the others, or give another folder with --out";
inline constexpr const char* kModelOfFirstCommand = " is the model, as before";
inline constexpr const char* kOtherModel =
    " exists and is another model; move it away, or give another folder with --out";
inline constexpr const char* kHasItsModel =
    " is a case with another model; leave --model out, or give another folder with --out";
inline constexpr const char* kNotADirection =
    ": give three numbers, what points up in the trunk's frame: left, up, forward; 0,-1,0 is head down";
inline constexpr const char* kNotClamped =
    ": the trunk is not clamped in it, and recordings of the runtime on the floor are not simulated; take an "
    "experiment with `trunk = clamped`";
}  // namespace messages

/// Throws std::runtime_error with the path and the reason.
std::string textOf(const std::string& path);

/// Throws std::runtime_error if it exists.
void requireNew(const std::string& path);
/// With those above it, as far as they are missing. Throws std::runtime_error with the path and the reason.
void makeFolder(const std::string& path);
/// PATH of the case.json that a command will write into the folder; throws std::runtime_error if it exists.
std::string newCaseFile(const std::string& folder);
/// Before a long computation: throws as writeTextFile() would after it. Nothing stays, and no file is changed.
void requireWritable(const std::string& path);

/// The same for the files of a report in this folder, which need not exist.
void requireReportFolder(const std::string& path);

/// The body of `model` for a model file in the folder; if that finds another one, stderr says so.
void putBody(const twin::Model& model, const std::string& folder, twin::OtherBody other);
/// Writes the text of a model file, with the body of `model` beside it. Another body that is there is kept.
void writeModelFile(const std::string& path, const std::string& text, const twin::Model& model);

/// That of --report, else one under gap-report that is named after `otherwise`.
std::string reportFolder(const Arguments& given, const std::string& otherwise);
/// Says where the report is, and opens it where a person sits in front of a screen.
void showReport(const Arguments& given, const std::string& folder, bool has_effects);

/// " --model FILE" as it was given; else nothing.
std::string modelOption(const Arguments& given);

}  // namespace darwinop::gap
