// A picture beneath the table: its place and size, how it is kept, and the hand that brings it there.
#include "editor/underlay.h"

#include <rapidcheck.h>
#include <stb/stb_image_write.h>
#include <catch2/catch.hpp>

#include <cmath>

#include "editor/keep_preferences.h"
#include "editor/lay_under.h"
#include "engine/core/at.h"
#include "engine/io/png.h"
#include "tests/editor/desk.h"

using namespace pinfield;
using namespace pinfield::editor;
using namespace pinfield::editor::test;

namespace {

double between(double least, double most) { return least + (most - least) * *rc::gen::inRange(0, 1'000'001) / 1e6; }

/// In braces, so that every compiler draws x first.
Vec2 any_pixels() { return Vec2{*rc::gen::inRange(1, 5000), *rc::gen::inRange(1, 5000)}; }

Underlay any_underlay() {
    Underlay underlay{.path = "/a photo.png"};
    underlay.centre = {between(-2, 2), between(-2, 2)};
    underlay.width = between(0.2, 2);
    underlay.quarter_turns = *rc::gen::inRange(0, 4);
    underlay.opacity = between(least_opacity, 1);
    underlay.shown = *rc::gen::arbitrary<bool>();
    underlay.locked = *rc::gen::arbitrary<bool>();
    return underlay;
}

/// A place of the unturned picture (pixels, y up from its lower left corner), as a place of the picture that is shown.
Vec2 shown_place(const Vec2& pixel, const Vec2& pixels, int quarter_turns) {
    Vec2 own = pixel.cwiseQuotient(pixels) - Vec2(0.5, 0.5);
    for (int i = 0; i < quarter_turns; ++i) own = {-own.y(), own.x()};
    return own + Vec2(0.5, 0.5);
}

std::vector<unsigned char> checkered(int width, int height, int channels) {
    std::vector<unsigned char> out;
    for (int i = 0; i < width * height; ++i)
        for (int c = 0; c < channels; ++c)
            out.push_back(static_cast<unsigned char>(c == 3 ? 255 : (i * 37 + c * 91 + i / width * 11) % 256));
    return out;
}

/// The table with a picture under it, and a mouse.
class PictureDesk : public Desk {
public:
    explicit PictureDesk(int width = 200, int height = 100) {
        static_cast<void>(write_png(photo(), width, height, checkered(width, height, 3)));
        lay_under(state_, photo());
        frames(3);
    }
    std::string photo() const { return folder_.file("photo.png"); }
    const Underlay& underlay() const { return state_.aids.underlay; }
    void click(const Vec2& at) { drag(at, at); }
    bool reads(std::string_view words) const {
        return std::any_of(seen_.begin(), seen_.end(), [&](const ScreenText& text) { return text.text.starts_with(words); });
    }
};

}  // namespace

TEST_CASE("two points of a picture come to the distance that is said, the first stays, and nothing is bent") {
    CHECK(rc::check("scaled by points", [] {
        const Vec2 pixels = any_pixels();
        RC_PRE(pixels.maxCoeff() < 8 * pixels.minCoeff());
        const Underlay before = any_underlay();
        const Vec2 a(between(0, 1), between(0, 1)), b(between(0, 1), between(0, 1));
        const Box2 box = box_of(before, pixels);
        const double now = length(world_from_picture(box, b) - world_from_picture(box, a)), wanted = now * between(0.5, 2);
        RC_PRE(now > 0.01);
        const Underlay after = scaled_by_points(before, pixels, a, b, wanted);
        const Box2 grown = box_of(after, pixels);
        RC_ASSERT(std::fabs(length(world_from_picture(grown, b) - world_from_picture(grown, a)) - wanted) < 1e-9);
        RC_ASSERT(length(world_from_picture(grown, a) - world_from_picture(box, a)) < 1e-9);
        RC_ASSERT(std::fabs(grown.size().x() * box.size().y() - grown.size().y() * box.size().x()) < 1e-9);
        RC_ASSERT(length(picture_from_world(grown, world_from_picture(grown, b)) - b) < 1e-9);
    }));
}

TEST_CASE("points that are one place, and distances that no picture can have, leave it as it is") {
    const Underlay before{.path = "/photo.png", .centre = {0.3, 0.4}, .width = 0.5};
    const Vec2 pixels(200, 100);
    CHECK(scaled_by_points(before, pixels, {0.5, 0.5}, {0.5, 0.5}, 0.1) == before);
    CHECK(scaled_by_points(before, pixels, {0, 0}, {1, 0}, 1e6) == before);
    CHECK(scaled_by_points(before, pixels, {0, 0}, {1, 0}, 1e-6) == before);
    CHECK(with_width(before, pixels, 1e9).width == most_underlay);
    CHECK(with_width(before, pixels, 0).width == Approx(2 * least_underlay));  // its height is the least
}

TEST_CASE("a quarter turn keeps a pixel's size and the middle, and four of them are none") {
    CHECK(rc::check("turned", [] {
        const Vec2 pixels = any_pixels();
        const Underlay before = any_underlay(), after = turned_left(before, pixels);
        const Vec2 p(between(0, pixels.x()), between(0, pixels.y())), q(between(0, pixels.x()), between(0, pixels.y()));
        const auto place = [&](const Underlay& underlay, const Vec2& pixel) {
            return Vec2(world_from_picture(box_of(underlay, pixels), shown_place(pixel, pixels, underlay.quarter_turns)) - underlay.centre);
        };
        // Each place goes a quarter about the middle, and with it every distance stays.
        for (const Vec2& pixel : {p, q}) {
            const Vec2 was = place(before, pixel);
            RC_ASSERT(length(place(after, pixel) - Vec2(-was.y(), was.x())) < 1e-9 * (1 + length(was)));
        }
        Underlay round = after;
        for (int i = 0; i < 3; ++i) round = turned_left(round, pixels);
        RC_ASSERT(round.quarter_turns == before.quarter_turns);
        RC_ASSERT(std::fabs(round.width - before.width) < 1e-9);
    }));
}

TEST_CASE("a new picture lies wholly within the table, and touches two of its edges") {
    CHECK(rc::check("fitted", [] {
        const Vec2 pixels = any_pixels(), table(between(0.2, 1), between(0.2, 2));
        RC_PRE(pixels.maxCoeff() < 10 * pixels.minCoeff());
        Underlay underlay = any_underlay();
        underlay = fitted_to(underlay, pixels, table);
        const Vec2 room = table - box_of(underlay, pixels).size();
        RC_ASSERT(room.minCoeff() > -1e-12);
        RC_ASSERT(room.minCoeff() < 1e-12);
        RC_ASSERT(length(underlay.centre - 0.5 * table) < 1e-12);
    }));
}

TEST_CASE("an underlay is kept from one run to the next, with its guides, to the last bit") {
    CHECK(rc::check("kept", [] {
        TableAids aids;
        aids.underlay = any_underlay();
        if (*rc::gen::arbitrary<bool>()) aids.guides.push_back({1, between(0, 1)});
        RC_ASSERT(read_aids(write_aids("/tables/pen.yaml", aids)) == aids);
    }));
    CHECK(write_aids("/pen.yaml", {}) == "table: /pen.yaml\n");
    // What is not understood leaves the usual value; without a width there is no underlay.
    const TableAids odd = read_aids(
        "underlay: /p.png\nunderlay_width: 500mm\nunderlay_turns: 7\nunderlay_opacity: -1\nunderlay_centre: 3\nunderlay_shown: maybe\n");
    CHECK(odd.underlay == Underlay{.path = "/p.png", .width = 0.5});
    CHECK(read_aids("underlay: /p.png\nunderlay_width: 900m\n") == TableAids{});
    CHECK(read_aids("underlay_width: 500mm\n") == TableAids{});
}

TEST_CASE("pictures are read as they were written, halved where they are too large, and refused with the reason") {
    const Folder folder;
    const std::vector<unsigned char> pixels = checkered(40, 30, 4);
    REQUIRE(write_png(folder.file("whole.png"), 40, 30, pixels));
    const Result<Bitmap> whole = read_picture(folder.file("whole.png"));
    REQUIRE(whole);
    CHECK(whole->width == 40);
    CHECK(whole->height == 30);
    CHECK(whole->rgba == pixels);
    const Result<Bitmap> half = read_picture(folder.file("whole.png"), 20);
    REQUIRE(half);
    CHECK(half->width == 20);
    CHECK(half->height == 15);
    for (const std::size_t i : {0U, 5U, 41U}) {
        const std::size_t x = i / 4 % 20, y = i / 4 / 20, c = i % 4;
        int sum = 2;
        for (const std::size_t dy : {0U, 1U})
            for (const std::size_t dx : {0U, 1U}) sum += pixels[4 * ((2 * y + dy) * 40 + 2 * x + dx) + c];
        CHECK(half->rgba[i] == sum / 4);
    }
    // A gray JPEG: lossy, but not by much where all is one color.
    const std::vector<unsigned char> gray(64 * 32 * 3, 130);
    REQUIRE(stbi_write_jpg(folder.file("gray.JPG").c_str(), 64, 32, 3, gray.data(), 90));
    const Result<Bitmap> jpeg = read_picture(folder.file("gray.JPG"));
    REQUIRE(jpeg);
    CHECK(jpeg->width == 64);
    CHECK(std::abs(int{jpeg->rgba[4 * 500]} - 130) <= 2);
    CHECK(jpeg->rgba[4 * 500 + 3] == 255);

    CHECK_THAT(read_picture(folder.write("words.png", "no picture")).error().message, Catch::Contains("is no PNG or JPEG"));
    const std::string png = folder.read("whole.png");
    CHECK_THAT(read_picture(folder.write("cut.png", png.substr(0, png.size() / 2))).error().message, Catch::Contains("is damaged"));
    CHECK_FALSE(read_picture(folder.file("nowhere.png")));
    std::string vast = png;
    vast.replace(16, 8, std::string("\0\0\x4e\x20\0\0\x27\x10", 8));
    CHECK_THAT(read_picture(folder.write("vast.png", vast)).error().message, Catch::Contains("too many"));
    CHECK(is_picture("/a/Photo.JPeG"));
    CHECK_FALSE(is_picture("/a.png/table.yaml"));
}

TEST_CASE("a drag moves the picture, two clicks and a distance bring it to size; the table's text does not change") {
    PictureDesk desk;
    const std::string text = desk.state().document.source().text();
    REQUIRE(desk.underlay().width == Approx(0.5));
    desk.drag(desk.on_table(0.3, 0.55), desk.on_table(0.34, 0.52));
    CHECK(length(desk.underlay().centre - Vec2(0.29, 0.47)) < 1e-9);
    desk.click(desk.on_table(0.2, 0.45));
    CHECK(desk.reads("Now the other point"));
    desk.click(desk.on_table(0.4, 0.45));
    REQUIRE(desk.reads("Distance"));
    CHECK(ImGui::GetIO().WantTextInput);  // it is typed at once
    for (const char c : {'5', '0'}) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
    desk.frames(1);
    ImGui::GetIO().KeysDown[ImGuiKey_Enter] = true;
    desk.frames(1);
    ImGui::GetIO().KeysDown[ImGuiKey_Enter] = false;
    desk.frames(1);
    CHECK(desk.underlay().width == Approx(0.125));
    CHECK(length(desk.underlay().centre - Vec2(0.2 + 0.25 * 0.09, 0.45 + 0.25 * 0.02)) < 1e-9);
    CHECK(desk.state().document.source().text() == text);
    CHECK_FALSE(desk.state().document.can_undo());
}

TEST_CASE("Esc takes a drag of the picture back, and then its points") {
    PictureDesk desk;
    const Underlay before = desk.underlay();
    desk.move_to(desk.on_table(0.3, 0.55));
    desk.button(true);
    desk.move_to(desk.on_table(0.4, 0.65));
    CHECK_FALSE(desk.underlay() == before);
    CHECK(cancel_drag(desk.state(), desk.ui()));
    CHECK(desk.underlay() == before);
    desk.button(false);
    CHECK(desk.ui().underlay.points.empty());
    desk.click(desk.on_table(0.3, 0.55));
    CHECK(desk.ui().underlay.points.size() == 1);
    CHECK(cancel_drag(desk.state(), desk.ui()));
    CHECK_FALSE(cancel_drag(desk.state(), desk.ui()));
}

TEST_CASE("a point of the picture is dragged by itself, and what is locked stays") {
    PictureDesk desk;
    desk.click(desk.on_table(0.3, 0.55));
    const Underlay before = desk.underlay();
    desk.drag(desk.on_table(0.3, 0.55), desk.on_table(0.35, 0.5));
    CHECK(desk.underlay() == before);
    CHECK(length(world_from_picture(box_of(before, {200, 100}), at(desk.ui().underlay.points, 0)) - Vec2(0.35, 0.5)) < 1e-9);
    run(desk.state(), "underlay.lock");
    desk.drag(desk.on_table(0.2, 0.5), desk.on_table(0.25, 0.5));
    CHECK(desk.underlay().centre == before.centre);
    CHECK(desk.state().message_is_problem);
    CHECK_FALSE(enabled(desk.state(), "underlay.turn"));
}

TEST_CASE("a picture dropped onto the window goes under the table, all else is opened; a broken one is said and leaves what was there") {
    PictureDesk desk;
    AppState& state = desk.state();
    take_dropped_file(state, desk.folder().write("broken.png", "no picture"));
    CHECK_THAT(state.message, Catch::Contains("is no PNG or JPEG"));
    CHECK(state.message_is_problem);
    CHECK(desk.underlay().path == desk.photo());
    take_dropped_file(state, desk.folder().write("other.yaml", pen));
    CHECK(state.document.path() == desk.folder().file("other.yaml"));
    CHECK(desk.underlay().path.empty());
    desk.frames(1);
    CHECK(state.tool == Tool::select);
    CHECK_FALSE(underlay_pixels(state));
    take_dropped_file(state, desk.photo());
    CHECK(desk.underlay().path == desk.photo());
    run(state, "underlay.remove");
    desk.frames(1);
    CHECK_FALSE(state.underlay.bitmap);
    CHECK_FALSE(enabled(state, "tool.underlay"));
}

TEST_CASE("an underlay comes back with its table; a missing picture is said, and found again when it is there again") {
    PictureDesk desk;
    AppState& state = desk.state();
    const Folder home;
    load_preferences(state, home.file(""));
    lay_under(state, desk.photo());
    run(state, "underlay.fainter");
    const Underlay kept = desk.underlay();
    CHECK(kept.opacity == Approx(0.5));
    keep_preferences(state);
    std::filesystem::rename(desk.photo(), desk.photo() + ".away");
    AppState next = {catalog(), *Document::open(desk.folder().file("table.yaml"), catalog())};
    load_preferences(next, home.file(""));
    advance(next, 0);
    CHECK(next.aids.underlay == kept);
    CHECK_THAT(next.message, Catch::Contains("No underlay"));
    CHECK(next.message_is_problem);
    CHECK_FALSE(underlay_pixels(next));
    std::filesystem::rename(desk.photo() + ".away", desk.photo());
    run(next, "underlay.show");
    run(next, "underlay.show");
    advance(next, 0);
    CHECK(underlay_pixels(next) == Vec2(200, 100));
    CHECK(next.aids.underlay == kept);
}
