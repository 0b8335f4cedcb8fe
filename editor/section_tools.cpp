#include "editor/section_tools.h"

#include <fmt/format.h>

#include <span>

#include "engine/core/at.h"

namespace pinfield::editor {
namespace {

constexpr double test_seconds = 10;

std::optional<std::string> one(Document& document, const Edit& edit, const std::string& label) {
    return document.edit(std::span(&edit, 1), label);
}

std::string name_of_test(const Document& document, int test) {
    const std::string& name = at(document.scene().tests, test).name;
    return name.empty() ? fmt::format("test {}", test + 1) : fmt::format("test {}", name);
}

}  // namespace

std::vector<std::string> keys_in(std::string_view text) {
    std::vector<std::string> keys;
    while (!text.empty()) {
        const std::size_t begin = text.find_first_not_of(" ,[]");
        if (begin == std::string_view::npos) break;
        text.remove_prefix(begin);
        const std::size_t length = std::min(text.find_first_of(" ,[]"), text.size());
        keys.emplace_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return keys;
}

std::optional<std::string> add_input(Document& document, const std::string& name, const std::vector<std::string>& keys) {
    const int behind = static_cast<int>(document.scene().inputs.size());
    return one(document, InsertInput{{name, keys, {}}, behind}, fmt::format("New input {}", name));
}

std::optional<std::string> rename_input(Document& document, int input, const std::string& name) {
    const std::string from = at(document.scene().inputs, input).name;
    return one(document, Rename{{}, from, name, true}, fmt::format("Rename {} to {}", from, name));
}

std::optional<std::string> bind_input(Document& document, int input, const std::vector<std::string>& keys) {
    return one(document, SetKeys{input, keys}, fmt::format("Keys of {}", at(document.scene().inputs, input).name));
}

std::optional<std::string> remove_input(Document& document, int input) {
    return one(document, RemoveInput{input}, fmt::format("Delete input {}", at(document.scene().inputs, input).name));
}

std::optional<std::string> add_test(Document& document, const std::string& name) {
    TableTest test;
    test.name = name;
    test.run = test_seconds;
    test.expectations.push_back({"escaped", "==", 0, "escaped == 0", {}});
    const int behind = static_cast<int>(document.scene().tests.size());
    return one(document, InsertTest{test, behind, {}}, fmt::format("New test {}", name));
}

std::optional<std::string> rename_test(Document& document, int test, const std::string& name) {
    return one(document, RenameTest{test, name}, fmt::format("Rename {}", name_of_test(document, test)));
}

std::optional<std::string> remove_test(Document& document, int test) {
    return one(document, RemoveTest{test}, fmt::format("Delete {}", name_of_test(document, test)));
}

}  // namespace pinfield::editor
