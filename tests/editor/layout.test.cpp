// Which panels stand in a window of some size.
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

#include "tests/editor/screen.h"
#include "tests/editor/support.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

class Editor : public Screen {
public:
    explicit Editor(ImVec2 size) : Screen(size), state_(opened_state(folder_)) {
        state_.preferences.show_source = true;
        select(state_, id_of(state_.document, "pop"));
        for (int i = 0; i < 4; ++i)
            frame_of([&] {
                draw_panels(state_, ui_);
                advance(state_, 0);
            });
    }
    bool shows(std::string_view panel) const {
        return std::any_of(seen_.begin(), seen_.end(), [&](const ScreenText& text) { return text.window.starts_with(panel); });
    }
    double table_width() const { return state_.view.size.x(); }

private:
    Folder folder_;
    AppState state_;
};

}  // namespace

TEST_CASE("beside the source there is the tree wherever both can be read; the inspector goes before it, and the table keeps its part") {
    for (const float width : {320.0f, 500.0f, 640.0f, 689.0f, 700.0f, 800.0f, 1000.0f, 1280.0f, 3840.0f}) {
        INFO(width << " pixels wide");
        const Editor editor({width, 500});
        CHECK(editor.shows("##source"));
        CHECK(editor.shows("##hierarchy") == (width >= 689));
        CHECK(editor.shows("##inspector") == (width >= 1200));
        CHECK(editor.table_width() >= std::min(240.0, width - 9.0) - 1);
    }
}
