#include "editor/path_question.h"

#include <cassert>

#include "editor/underlay.h"

namespace pinfield::editor {

const PathQuestion& path_question(std::string_view action) {
    static constexpr PathQuestion questions[] = {
        {"file.open", "Open a table", "Open", "Tables", "*.yaml *.yml", "No tables in this folder."},
        {"file.save_as", "Save the table as", "Save", "Tables", "*.yaml *.yml", "No tables in this folder.", true},
        {"underlay.open", "Lay a picture under the table", "Open", "Pictures", "*.png *.jpg *.jpeg *.PNG *.JPG *.JPEG",
         "No pictures in this folder."},
    };
    for (const PathQuestion& question : questions)
        if (question.action == action) return question;
    assert(false && "only actions that ask for a path have a question");
    return questions[0];
}

bool is_wanted(const PathQuestion& question, std::string_view name) {
    if (question.action == "underlay.open") return is_picture(name);
    return name.ends_with(".yaml") || name.ends_with(".yml");
}

}  // namespace pinfield::editor
