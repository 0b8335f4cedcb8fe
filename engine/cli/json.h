// JSON as text: just what the commands print.
#pragma once
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

namespace pinfield::cli {

/// Quoted and escaped: valid whatever the bytes, as those that are no UTF-8 (of a path) become U+FFFD, and harmless on a terminal.
std::string json_text(std::string_view text);
/// Shortest text that reads back as the same double; null where JSON has no word for it (infinity, NaN).
std::string json_number(double x);

/// An object on one line, its members in the order they were added.
class JsonObject {
public:
    JsonObject& add(std::string_view key, double value) { return add_raw(key, json_number(value)); }
    JsonObject& add(std::string_view key, std::string_view value) { return add_raw(key, json_text(value)); }
    JsonObject& add(std::string_view key, const char* value) { return add_raw(key, json_text(value)); }
    JsonObject& add(std::string_view key, bool value) { return add_raw(key, value ? "true" : "false"); }
    template <std::integral Integer>
    JsonObject& add(std::string_view key, Integer value) {
        return add_raw(key, std::to_string(value));
    }
    JsonObject& add(std::string_view key, const JsonObject& value) { return add_raw(key, value.text()); }
    /// `json` is a JSON value already.
    JsonObject& add_raw(std::string_view key, std::string_view json);
    std::string text() const { return "{" + members_ + "}"; }

private:
    std::string members_;
};

/// [first, second, ...] of JSON values.
std::string json_array(const std::vector<std::string>& values);

}  // namespace pinfield::cli
