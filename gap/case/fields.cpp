// Strict reading of JSON.
#include "gap/case/fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/text/nearest.hpp"
#include "experiments/logs/header.hpp"
#include "gap/case/case.hpp"
#include "gap/case/messages.hpp"

namespace darwinop::gap {
namespace {

constexpr auto kForPeople = std::to_array<std::string_view>(
    {"note", "notes", "comment", "description", "source", "name", "title", "date", "provenance"});

/// As an error shows it.
std::string shown(const Json& value) {
  if (value.is_string()) return logs::quotedField(value.get_ref<const std::string&>());
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list";
  return value.dump();
}

std::size_t lineOf(std::string_view text, std::size_t byte) {
  return 1 + static_cast<std::size_t>(std::ranges::count(text.substr(0, byte), '\n'));
}

}  // namespace

Fields::Fields(const Json& json, std::string file, std::string path)
    : json_{&json}, file_{std::move(file)}, path_{std::move(path)} {}

bool Fields::has(std::string_view key) {
  leave(key);
  const auto found = json_->find(std::string{key});
  return found != json_->end() && !found->is_null();
}

double Fields::number(std::string_view key, const twin::NumberRule& rule) {
  const std::string wanted = "a number, " + twin::allowed(rule);
  const Json& value = needed(key, wanted);
  if (!value.is_number()) fail(key, "is " + shown(value) + "; it has to be " + wanted);
  const double x = value.get<double>();
  if (!(x >= rule.low && x <= rule.high)) fail(key, "is " + shown(value) + "; it has to be " + wanted);
  return x;
}

double Fields::number(std::string_view key, const twin::NumberRule& rule, double otherwise) {
  return has(key) ? number(key, rule) : otherwise;
}

std::vector<double> Fields::numbers(std::string_view key, const twin::NumberRule& rule, std::size_t count) {
  const std::string wanted = "a list of " + std::to_string(count) + " numbers, each " + twin::allowed(rule);
  const Json& value = needed(key, wanted);
  const auto fits = [&](const Json& item) {
    return item.is_number() && item.get<double>() >= rule.low && item.get<double>() <= rule.high;
  };
  if (!value.is_array() || value.size() != count || !std::ranges::all_of(value, fits))
    fail(key, "is " + (value.is_array() ? value.dump() : shown(value)) + "; it has to be " + wanted);
  return value.get<std::vector<double>>();
}

std::string Fields::text(std::string_view key) {
  const Json& value = needed(key, "a text");
  if (!value.is_string()) fail(key, "is " + shown(value) + "; it has to be a text");
  return value.get<std::string>();
}

std::string Fields::text(std::string_view key, std::string_view otherwise) {
  return has(key) ? text(key) : std::string{otherwise};
}

bool Fields::flag(std::string_view key, bool otherwise) {
  if (!has(key)) return otherwise;
  const Json& value = needed(key, "true or false");
  if (!value.is_boolean()) fail(key, "is " + shown(value) + "; it has to be true or false");
  return value.get<bool>();
}

std::size_t Fields::word(std::string_view key, const std::vector<std::string_view>& words, std::size_t otherwise) {
  if (!has(key) && otherwise < words.size()) return otherwise;
  const std::string choice = text::listed(words, "or");
  const Json& value = needed(key, choice);
  const auto found = value.is_string() ? std::ranges::find(words, value.get_ref<const std::string&>()) : words.end();
  if (found == words.end()) fail(key, "is " + shown(value) + "; it has to be " + choice);
  return static_cast<std::size_t>(found - words.begin());
}

Fields Fields::object(std::string_view key) {
  const Json& value = needed(key, "an object, { }");
  if (!value.is_object()) fail(key, "is " + shown(value) + "; it has to be an object, { }");
  return {value, file_, pathOf(key)};
}

std::vector<Fields> Fields::list(std::string_view key) {
  const Json& value = needed(key, "a list, [ ]");
  if (!value.is_array()) fail(key, "is " + shown(value) + "; it has to be a list, [ ]");
  std::vector<Fields> items;
  for (const Json& item : value) {
    const std::string name = std::string{key} + "[" + std::to_string(items.size()) + "]";
    if (!item.is_object()) fail(name, "is " + shown(item) + "; it has to be an object, { }");
    items.emplace_back(item, file_, pathOf(name));
  }
  return items;
}

void Fields::leave(std::string_view key) {
  if (std::ranges::find(known_, key) == known_.end()) known_.emplace_back(key);
}

std::vector<std::string> Fields::untaken() const {
  std::vector<std::string> left;
  for (const auto& [key, value] : json_->items())
    if (std::ranges::find(known_, key) == known_.end() && std::ranges::find(kForPeople, key) == kForPeople.end())
      left.push_back(key);
  return left;
}

void Fields::finish() const {
  const std::vector<std::string> left = untaken();
  if (left.empty()) return;
  const std::vector<std::string_view> known{known_.begin(), known_.end()};
  fail(left.front(), std::string{messages::kUnknownKey} + "; " + text::suggestion(left.front(), known));
}

void Fields::finish(std::vector<std::string>& warnings) const {
  const std::vector<std::string_view> known{known_.begin(), known_.end()};
  for (const std::string& key : untaken()) {
    const auto within = [&](std::string_view other) {
      constexpr std::size_t kWord = 4;  // letters; shorter ones are in anything
      return std::min(key.size(), other.size()) >= kWord &&
             (key.find(other) != std::string::npos || other.find(key) != std::string_view::npos);
    };
    if (const auto meant = std::ranges::find_if(known, within); meant != known.end())
      fail(key, std::string{messages::kUnknownKey} + "; did you mean " + std::string{*meant} + "?");
    if (text::nearest(key, known)) fail(key, std::string{messages::kUnknownKey} + "; " + text::suggestion(key, known));
    warnings.push_back(file_ + ": " + logs::quotedField(pathOf(key)) + " " + messages::kUnknownKey + " and left out");
  }
}

std::vector<std::string> Fields::keys() const {
  std::vector<std::string> all;
  for (const auto& [key, value] : json_->items()) all.push_back(key);
  return all;
}

void Fields::fail(std::string_view key, const std::string& sentence) const {
  std::string path = logs::quotedField(pathOf(key));
  path.front() = '`';
  path.back() = '`';
  throw BadInput(file_ + ": " + path + " " + sentence);
}

const Json& Fields::needed(std::string_view key, const std::string& wanted) {
  leave(key);
  const auto found = json_->find(std::string{key});
  if (found == json_->end()) fail(key, messages::kMissing + wanted);
  return *found;
}

std::string Fields::pathOf(std::string_view key) const {
  return path_.empty() ? std::string{key} : path_ + "." + std::string{key};
}

bool isWholeRobot(const Json& json) {
  const auto family = json.find("family");
  return family != json.end() && *family == "body";
}

Json parseJson(std::string_view text, const std::string& file) {
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
    using Event = Json::parse_event_t;
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::key && !keys.back().insert(parsed.get_ref<const std::string&>()).second)
      throw BadInput(file + ": the key " + logs::quotedField(parsed.get_ref<const std::string&>()) + " " +
                     messages::kGivenTwice + " in one object; keep one of the two");
    return true;
  };
  try {
    Json json = Json::parse(text, watch);
    if (!json.is_object())
      throw BadInput(file + ": " + messages::kNotJsonObject + "; a case begins with { and ends with }");
    return json;
  } catch (const Json::parse_error& error) {
    throw BadInput(file + ", line " + std::to_string(lineOf(text, error.byte)) + ": " + messages::kNotJson +
                   "; a comma or a quotation mark too many or too few?");
  } catch (const Json::exception&) {
    throw BadInput(file + ": " + messages::kDigitsBeyondDouble);
  }
}

}  // namespace darwinop::gap
