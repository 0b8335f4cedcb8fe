// What an author does to a table's inputs and tests, each as one undo step. No window, no ImGui.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "editor/document.h"

namespace pinfield::editor {

/// "Z, LeftShift" as keys.
std::vector<std::string> keys_in(std::string_view text);

// Why not, or nothing. Inputs and tests are numbered as the file has them.

/// A new input behind the others.
std::optional<std::string> add_input(Document& document, const std::string& name, const std::vector<std::string>& keys);
/// All that is moved by it follows.
std::optional<std::string> rename_input(Document& document, int input, const std::string& name);
std::optional<std::string> bind_input(Document& document, int input, const std::vector<std::string>& keys);
std::optional<std::string> remove_input(Document& document, int input);

/// A new test behind the others: that no ball escapes in ten seconds, to be written on by its author.
std::optional<std::string> add_test(Document& document, const std::string& name);
std::optional<std::string> rename_test(Document& document, int test, const std::string& name);
std::optional<std::string> remove_test(Document& document, int test);

}  // namespace pinfield::editor
