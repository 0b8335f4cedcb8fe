#include "editor/widgets/icons.h"

#include <algorithm>
#include <array>

#include "engine/core/trig.h"

namespace pinfield::editor {

namespace {

/// A pen over a unit square, (-1, -1) at the top left.
struct Pen {
    ImDrawList& list;
    ImVec2 centre;
    float half = 0, width = 0;
    ImU32 color = 0;

    ImVec2 at(float x, float y) const { return {centre.x + half * x, centre.y + half * y}; }
    void line(float ax, float ay, float bx, float by) const { list.AddLine(at(ax, ay), at(bx, by), color, width); }
    void circle(float x, float y, float r) const { list.AddCircle(at(x, y), half * r, color, 0, width); }
    void dot(float x, float y, float r) const { list.AddCircleFilled(at(x, y), half * r, color); }
    void box(float ax, float ay, float bx, float by, float round = 0) const {
        list.AddRect(at(ax, ay), at(bx, by), color, half * round, 0, width);
    }
    void bar(float ax, float ay, float bx, float by, float round = 0) const {
        list.AddRectFilled(at(ax, ay), at(bx, by), color, half * round);
    }
    void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const { list.AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), color); }
    template <std::size_t N>
    void path(const std::array<ImVec2, N>& points, bool closed) const {
        for (const ImVec2& p : points) list.PathLineTo(at(p.x, p.y));
        list.PathStroke(color, closed ? ImDrawFlags_Closed : ImDrawFlags_None, width);
    }
    void arc(float x, float y, float r, double from_degrees, double to_degrees) const {
        list.PathArcTo(at(x, y), half * r, static_cast<float>(radians(from_degrees)), static_cast<float>(radians(to_degrees)));
        list.PathStroke(color, ImDrawFlags_None, width);
    }
};

void draw_transport(const Pen& pen, Icon icon) {
    switch (icon) {
        case Icon::play: pen.triangle({-0.6f, -0.8f}, {-0.6f, 0.8f}, {0.8f, 0}); break;
        case Icon::pause:
            pen.bar(-0.65f, -0.75f, -0.18f, 0.75f, 0.1f);
            pen.bar(0.18f, -0.75f, 0.65f, 0.75f, 0.1f);
            break;
        case Icon::step:
            pen.triangle({-0.75f, -0.75f}, {-0.75f, 0.75f}, {0.35f, 0});
            pen.bar(0.42f, -0.75f, 0.72f, 0.75f, 0.1f);
            break;
        default:  // reset
            pen.arc(0, 0.05f, 0.72f, -60, 210);
            pen.triangle({0.0f, -0.62f}, {0.55f, -1.0f}, {0.62f, -0.22f});
            break;
    }
}

void draw_kind(const Pen& pen, Icon icon) {
    switch (icon) {
        case Icon::shape: pen.circle(0, 0, 0.72f); break;
        case Icon::operation:
            pen.circle(-0.32f, 0, 0.56f);
            pen.circle(0.32f, 0, 0.56f);
            break;
        case Icon::part: {
            std::array<ImVec2, 6> hexagon;
            for (std::size_t i = 0; i < 6; ++i) {
                const SineCosine t = sine_cosine_degrees(60.0 * static_cast<double>(i) + 30);
                hexagon[i] = {static_cast<float>(0.82 * t.cosine), static_cast<float>(0.82 * t.sine)};
            }
            pen.path(hexagon, true);
            pen.dot(0, 0, 0.24f);
            break;
        }
        case Icon::group:
            pen.box(-0.8f, -0.8f, 0.25f, 0.25f, 0.15f);
            pen.box(-0.25f, -0.25f, 0.8f, 0.8f, 0.15f);
            break;
        case Icon::table:
            pen.box(-0.55f, -0.85f, 0.55f, 0.85f, 0.25f);
            pen.line(-0.3f, 0.5f, -0.02f, 0.62f);
            pen.line(0.3f, 0.5f, 0.02f, 0.62f);
            break;
        case Icon::physics:
            pen.arc(-0.1f, 0.75f, 1.1f, -90, -25);
            pen.dot(0.55f, -0.45f, 0.28f);
            pen.line(-0.85f, 0.8f, 0.85f, 0.8f);
            break;
        default:  // material
            pen.bar(-0.6f, -0.6f, 0.6f, 0.6f, 0.3f);
            break;
    }
}

/// Five points up; filled, or its outline.
void draw_star(const Pen& pen, bool filled) {
    std::array<ImVec2, 10> points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SineCosine t = sine_cosine_degrees(36.0 * static_cast<double>(i) - 90);
        const double r = i % 2 == 0 ? 1.0 : 0.45;
        points[i] = {static_cast<float>(r * t.cosine), static_cast<float>(r * t.sine)};
    }
    if (!filled) return pen.path(points, true);
    for (std::size_t i = 0; i < points.size(); ++i) pen.triangle({0, 0}, points[i], points[(i + 1) % points.size()]);
}

void draw_mark(const Pen& pen, Icon icon) {
    switch (icon) {
        case Icon::star: draw_star(pen, true); break;
        case Icon::star_outline: draw_star(pen, false); break;
        case Icon::seen:
            pen.arc(0, 0.55f, 1.0f, 215, 325);
            pen.arc(0, -0.55f, 1.0f, 35, 145);
            pen.dot(0, 0, 0.24f);
            break;
        case Icon::hidden:
            pen.arc(0, 0.55f, 1.0f, 215, 325);
            pen.arc(0, -0.55f, 1.0f, 35, 145);
            pen.dot(0, 0, 0.24f);
            pen.line(-0.75f, 0.75f, 0.75f, -0.75f);
            break;
        case Icon::locked:
            pen.bar(-0.55f, -0.1f, 0.55f, 0.75f, 0.15f);
            pen.arc(0, -0.1f, 0.36f, 180, 360);
            break;
        case Icon::unlocked:
            pen.bar(-0.55f, -0.1f, 0.55f, 0.75f, 0.15f);
            pen.arc(0.72f, -0.1f, 0.36f, 180, 360);
            break;
        case Icon::error:
            pen.circle(0, 0, 0.85f);
            pen.line(-0.33f, -0.33f, 0.33f, 0.33f);
            pen.line(-0.33f, 0.33f, 0.33f, -0.33f);
            break;
        case Icon::warning:
            pen.path(std::array<ImVec2, 3>{{{0, -0.8f}, {0.88f, 0.72f}, {-0.88f, 0.72f}}}, true);
            pen.line(0, -0.25f, 0, 0.22f);
            pen.dot(0, 0.46f, 0.11f);
            break;
        case Icon::fine:
            pen.path(std::array<ImVec2, 3>{{{-0.65f, 0.05f}, {-0.2f, 0.5f}, {0.65f, -0.5f}}}, false);
            break;
        case Icon::search:
            pen.circle(-0.15f, -0.15f, 0.55f);
            pen.line(0.27f, 0.27f, 0.75f, 0.75f);
            break;
        case Icon::folder:
            pen.path(
                std::array<ImVec2, 6>{
                    {{-0.85f, 0.65f}, {-0.85f, -0.6f}, {-0.25f, -0.6f}, {-0.05f, -0.35f}, {0.85f, -0.35f}, {0.85f, 0.65f}}},
                true);
            break;
        case Icon::file:
            pen.path(std::array<ImVec2, 5>{{{-0.6f, -0.85f}, {0.2f, -0.85f}, {0.6f, -0.45f}, {0.6f, 0.85f}, {-0.6f, 0.85f}}}, true);
            break;
        case Icon::frame:
            for (const float x : {-1.0f, 1.0f})
                for (const float y : {-1.0f, 1.0f})
                    pen.path(std::array<ImVec2, 3>{{{x * 0.75f, y * 0.3f}, {x * 0.75f, y * 0.75f}, {x * 0.3f, y * 0.75f}}}, false);
            break;
        default: pen.dot(0, 0, 0.3f); break;
    }
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 color) {
    const Pen pen{list, centre, 0.5f * size, std::max(1.0f, size / 11), color};
    if (icon <= Icon::reset) draw_transport(pen, icon);
    else if (icon <= Icon::material) draw_kind(pen, icon);
    else draw_mark(pen, icon);
}

}  // namespace pinfield::editor
