// Camera controls, with the behaviour of the UVC driver.
#include "hil-mocks/camera/shim/controls.hpp"

#include <cerrno>
#include <cstdio>

namespace darwinop::hil::shim {
namespace {

constexpr std::uint32_t kNext = V4L2_CTRL_FLAG_NEXT_CTRL | V4L2_CTRL_FLAG_NEXT_COMPOUND;
constexpr const char* kFrequencies[] = {"Disabled", "50 Hz", "60 Hz"};

/// Row of the control, or of the next one if the flag requests that; kControlCount: none.
std::uint32_t rowOf(std::uint32_t id) {
  const bool next = (id & V4L2_CTRL_FLAG_NEXT_CTRL) != 0;
  if ((id & kNext) == V4L2_CTRL_FLAG_NEXT_COMPOUND) return kControlCount;
  const std::uint32_t plain = id & ~kNext;
  for (std::uint32_t i = 0; i < kControlCount; ++i)
    if (next ? kControls[i].id > plain : kControls[i].id == plain) return i;
  return kControlCount;
}

/// A control class, not a control.
bool isHeading(std::uint32_t row) {
  return kControls[row].type == V4L2_CTRL_TYPE_CTRL_CLASS;
}

std::int32_t clamped(const ControlRow& row, std::int32_t value) {
  return value < row.least ? row.least : value > row.most ? row.most : value;
}

}  // namespace

std::uint32_t Controls::flags(std::uint32_t row) const {
  if (isHeading(row)) return V4L2_CTRL_FLAG_READ_ONLY | V4L2_CTRL_FLAG_WRITE_ONLY;
  if (kControls[row].id != V4L2_CID_EXPOSURE_ABSOLUTE) return 0;
  return value_[rowOf(V4L2_CID_EXPOSURE_AUTO)] == V4L2_EXPOSURE_MANUAL ? 0 : V4L2_CTRL_FLAG_INACTIVE;
}

int Controls::describe(v4l2_queryctrl& query) const {
  const std::uint32_t i = rowOf(query.id);
  if (i == kControlCount) return EINVAL;
  const ControlRow& row = kControls[i];
  query = {};
  query.id = row.id;
  query.type = row.type;
  std::snprintf(reinterpret_cast<char*>(query.name), sizeof query.name, "%s", row.name);
  query.minimum = row.least;
  query.maximum = row.most;
  query.step = isHeading(i) ? 0 : 1;
  query.default_value = row.usual;
  query.flags = flags(i);
  return 0;
}

int Controls::describe(v4l2_query_ext_ctrl& query) const {
  v4l2_queryctrl plain = {};
  plain.id = query.id;
  if (const int error = describe(plain); error != 0) return error;
  query = {};
  query.id = plain.id;
  query.type = plain.type;
  std::snprintf(query.name, sizeof query.name, "%s", reinterpret_cast<const char*>(plain.name));
  query.minimum = plain.minimum;
  query.maximum = plain.maximum;
  query.step = static_cast<std::uint32_t>(plain.step);
  query.default_value = plain.default_value;
  query.flags = plain.flags;
  query.elem_size = sizeof(std::int32_t);
  query.elems = 1;
  return 0;
}

int Controls::describe(v4l2_querymenu& query) {
  const char* name = nullptr;
  if (query.id == V4L2_CID_POWER_LINE_FREQUENCY && query.index < 3) name = kFrequencies[query.index];
  // The camera lacks automatic (0) and shutter priority (2).
  if (query.id == V4L2_CID_EXPOSURE_AUTO && query.index == V4L2_EXPOSURE_MANUAL) name = "Manual Mode";
  if (query.id == V4L2_CID_EXPOSURE_AUTO && query.index == V4L2_EXPOSURE_APERTURE_PRIORITY)
    name = "Aperture Priority Mode";
  if (name == nullptr) return EINVAL;
  std::snprintf(reinterpret_cast<char*>(query.name), sizeof query.name, "%s", name);
  query.reserved = 0;
  return 0;
}

int Controls::get(std::uint32_t id, std::int32_t& value) const {
  const std::uint32_t i = rowOf(id & ~kNext);
  if (i == kControlCount || (id & kNext) != 0) return EINVAL;
  if (isHeading(i)) return EACCES;
  value = value_[i];
  return 0;
}

int Controls::check(std::uint32_t id, std::int32_t& value, std::uint32_t& row) const {
  row = rowOf(id & ~kNext);
  if (row == kControlCount || (id & kNext) != 0) return EINVAL;
  if (isHeading(row)) return EACCES;
  if ((flags(row) & V4L2_CTRL_FLAG_INACTIVE) != 0) return EACCES;  // automatic exposure
  if (kControls[row].type != V4L2_CTRL_TYPE_MENU) {
    value = clamped(kControls[row], value);
    return 0;
  }
  if (value != clamped(kControls[row], value)) return ERANGE;
  v4l2_querymenu entry = {};
  entry.id = id;
  entry.index = static_cast<std::uint32_t>(value);
  return describe(entry);
}

int Controls::set(std::uint32_t id, std::int32_t& value) {
  std::uint32_t row = 0;
  if (const int error = check(id, value, row); error != 0) return error;
  value_[row] = value;
  return 0;
}

int Controls::get(v4l2_ext_controls& list) const {
  list.error_idx = list.count;
  for (std::uint32_t i = 0; i < list.count; ++i) {
    std::int32_t value = 0;  // the list is packed: no references into it
    if (const int error = get(list.controls[i].id, value); error != 0) return error;
    list.controls[i].value = value;
  }
  return 0;
}

int Controls::set(v4l2_ext_controls& list, bool only_try) {
  for (std::uint32_t i = 0; i < list.count; ++i) {
    v4l2_ext_control& one = list.controls[i];
    std::uint32_t row = 0;
    std::int32_t value = one.value;
    const int error = only_try ? check(one.id, value, row) : set(one.id, value);
    if (error != 0) {
      list.error_idx = i;
      return error;
    }
    one.value = value;
  }
  return 0;
}

}  // namespace darwinop::hil::shim
