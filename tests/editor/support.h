// What the editor's tests share: a folder of real files, a commented table, and steps along a game.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include "editor/app_state.h"
#include "editor/starters.h"
#include "engine/scene/catalog.h"

namespace pinfield::editor::test {

inline std::shared_ptr<const Catalog> catalog() {
    static const auto shared = std::make_shared<const Catalog>(built_in_catalog());
    return shared;
}

/// A folder that goes away with the test.
class Folder {
public:
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "pinfield-editor-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string file(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(file(name), std::ios::binary) << text;
        return file(name);
    }
    std::string read(const std::string& name) const {
        std::ifstream in(file(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

private:
    std::filesystem::path path_;
};

/// A closed box with a bumper, a wall, a group and a ball that is thrown about; every line that matters has a comment.
inline const std::string pen = R"(pinfield: 1          # the format
table: {name: Pen, size: [0.5, 1.0], slope: 6.5}
materials:
  rubber: {restitution: 0.8, color: crimson}   # bouncy
scene:
  # the walls
  - domain: {children: [box: {size: [0.48, 0.98], at: [0.25, 0.5]}]}
  - bumper: {id: pop, at: [0.25, 0.70], radius: 24mm, kick: 0.8, material: rubber}  # the middle one
  - box: {id: shelf, at: [0.25, 300mm], size: [200mm, 0.02]}
  - group:
      id: corner
      at: [0.1, 0.1]
      turn: 90
      scale: 2
      children:
        - circle: {id: post, at: [0.01, 0.02], radius: 10mm}   # inside the group
        - circle: {id: nail, at: [0.03, 0.02], radius: 2mm, locked: true}
  - flipper: {id: bat, at: [0.30, 0.15], input: [left]}
  - spawn: {id: start, at: [0.25, 0.90], velocity: [0.01, 0]}
  - drain: {id: drain, at: [0.25, 0.02], size: [0.1, 20mm]}
inputs: {left: [Z, LeftShift]}
)";

inline Document opened(const Folder& folder, const std::string& text = pen) {
    return *Document::open(folder.write("table.yaml", text), catalog());
}
inline AppState opened_state(const Folder& folder, const std::string& text = pen) { return {catalog(), opened(folder, text)}; }

inline NodeId id_of(const Document& document, std::string_view path) {
    const Node* node = document.scene().find(path);
    return node ? node->id : NodeId{};
}

inline Document untitled() { return Document::untitled(catalog(), starters().front().text); }

inline AppState untitled_state() { return {catalog(), untitled()}; }

/// An edit of a node's field by name.
inline SetField change(const Document& document, std::string_view node, std::string_view field, Value value) {
    const Node& found = *document.scene().find(node);
    return {found.id, *found.type->find_field(field), std::move(value), true};
}

/// Lines that differ between two texts of the same number of lines; -1 when the numbers differ.
inline int changed_lines(const std::string& a, const std::string& b) {
    const SourceText x("", a), y("", b);
    if (x.line_count() != y.line_count()) return -1;
    int count = 0;
    for (int i = 1; i <= x.line_count(); ++i) count += x.line(i) != y.line(i);
    return count;
}

}  // namespace pinfield::editor::test
