// Parses the request member `find` and writes the message "found".
#include "monitor/search_message.hpp"

#include <array>
#include <cmath>
#include <string_view>

#include "core/sensors.hpp"
#include "monitor/json.hpp"

namespace darwinop::monitor {
namespace {

/// Names are those of the vision manager's setters.
struct WholeMember {
  const char* name;
  int ColourThresholds::*into;
  int least, most;
};
constexpr std::array<WholeMember, 4> kWholeMembers{{{"hue", &ColourThresholds::hue, 0, 360},
                                                    {"hueTolerance", &ColourThresholds::hue_tolerance, 0, 180},
                                                    {"minSaturation", &ColourThresholds::min_saturation, -1, 100},
                                                    {"minValue", &ColourThresholds::min_value, -1, 100}}};
struct PercentMember {
  const char* name;
  double PercentLimits::*into;
};
constexpr std::array<PercentMember, 2> kPercentMembers{
    {{"minPercent", &PercentLimits::min}, {"maxPercent", &PercentLimits::max}}};

std::string rangeText(const char* name, const char* kind, int least, int most) {
  return std::string{"find."} + name + " must be a " + kind + " from " + std::to_string(least) + " to " +
         std::to_string(most);
}

/// Reads one member if present; returns an error text or an empty string.
std::string takeWhole(const Json& request, const WholeMember& member, ColourThresholds& into) {
  const auto found = request.find(member.name);
  if (found == request.end()) return {};
  const double value = found->is_number() ? found->get<double>() : kUnknown;
  if (!(value >= member.least && value <= member.most) || value != std::trunc(value))
    return rangeText(member.name, "whole number", member.least, member.most);
  into.*member.into = static_cast<int>(value);
  return {};
}

std::string takePercent(const Json& request, const PercentMember& member, PercentLimits& into) {
  const auto found = request.find(member.name);
  if (found == request.end()) return {};
  const double value = found->is_number() ? found->get<double>() : kUnknown;
  if (!(value >= 0 && value <= 100)) return rangeText(member.name, "number", 0, 100);
  into.*member.into = value;
  return {};
}

/// RFC 4648, with padding.
std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kLetters[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace

std::string takeSearch(const Json& request, Subscription& subscription) {
  const auto find = request.find("find");
  if (find == request.end()) return {};
  if (find->is_null()) {
    subscription.find.reset();
    subscription.mask = false;
    return {};
  }
  if (!find->is_object()) return "find must be an object, such as {\"hue\": 355, \"hueTolerance\": 15}, or null";
  ColourQuery search;
  for (const WholeMember& member : kWholeMembers)
    if (std::string why = takeWhole(*find, member, search.colour); !why.empty()) return why;
  for (const PercentMember& member : kPercentMembers)
    if (std::string why = takePercent(*find, member, search.limits); !why.empty()) return why;
  const auto mask = find->find("mask");
  if (mask != find->end() && !mask->is_boolean()) return "find.mask must be true or false";
  subscription.mask = mask != find->end() && mask->get<bool>();
  subscription.find = search;
  return {};
}

Json searchJson(const Subscription& subscription) {
  if (!subscription.find) return nullptr;
  Json find;
  for (const WholeMember& member : kWholeMembers) find[member.name] = subscription.find->colour.*member.into;
  for (const PercentMember& member : kPercentMembers) find[member.name] = subscription.find->limits.*member.into;
  find["mask"] = subscription.mask;
  return find;
}

std::string colourMatchText(const ColourMatch& found, bool mask) {
  constexpr std::uint64_t kWraps = 0xFFFFFFFF;  // as the number in a picture's header
  const bool any = found.pixels > 0;
  const double all = static_cast<double>(found.width) * found.height;
  Json text;
  text["type"] = "found";
  text["picture"] = found.picture & kWraps;
  text["width"] = found.width;
  text["height"] = found.height;
  text["x"] = found.centre ? Json(found.centre->x) : Json(nullptr);
  text["y"] = found.centre ? Json(found.centre->y) : Json(nullptr);
  text["pixels"] = found.pixels;
  text["percent"] = rounded(100 * static_cast<double>(found.pixels) / all);
  text["box"] = any ? Json::array({found.left, found.top, found.right, found.bottom}) : Json(nullptr);
  if (mask) text["mask"] = base64(found.mask);
  return jsonText(text);
}

}  // namespace darwinop::monitor
