// What a picture of isolines looks like, once for `pinfield render` and for the editor's window: the formula below is compiled here, and
// its text is part of the window's shader. It keeps to what C++ and GLSL have in common, and to functions that are exact in both.
#pragma once
#include <algorithm>
#include <cmath>

namespace pinfield::isolines {

// GLSL's names, in C++.
struct vec3 {
    float x = 0, y = 0, z = 0;
    vec3(float r, float g, float b) : x(r), y(g), z(b) {}
};
inline float abs(float v) { return std::fabs(v); }
inline float min(float a, float b) { return std::min(a, b); }
inline float floor(float v) { return std::floor(v); }
inline float smoothstep(float lo, float hi, float v) {
    const float t = std::clamp((v - lo) / (hi - lo), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}
inline vec3 mix(const vec3& a, const vec3& b, float t) {
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.z + (b.z - a.z) * t};
}

/// A function as C++, and as the text `name` for a shader.
#define PINFIELD_CPP_AND_GLSL(name, ...) \
    inline __VA_ARGS__                   \
    inline constexpr const char* name = #__VA_ARGS__;

/// Display color at the signed distance d; all three in metres. Solids are blue, free space is like sand, which every kind of color vision
/// tells apart; both glow at the outline, which is white, and fade away from it. Every fifth line is stronger.
PINFIELD_CPP_AND_GLSL(isoline_color_source, vec3 isoline_color(float d, float spacing, float pixel) {
    float away = min(abs(d), 1000.0f);
    float depth = min(away / 0.120f, 1.0f);
    float fade = depth * (2.0f - depth);
    vec3 ink = d > 0.0f ? vec3(0.98f, 0.72f, 0.36f) : vec3(0.46f, 0.74f, 0.93f);
    vec3 c = d > 0.0f ? mix(vec3(0.47f, 0.31f, 0.14f), vec3(0.17f, 0.12f, 0.08f), fade)
                      : mix(vec3(0.13f, 0.25f, 0.36f), vec3(0.055f, 0.085f, 0.13f), fade);
    float lines = away / spacing;
    float to_line = abs(lines - floor(lines + 0.5f)) * spacing / pixel;
    float fifths = lines / 5.0f;
    float to_fifth = abs(fifths - floor(fifths + 0.5f)) * 5.0f * spacing / pixel;
    c = mix(c, ink, 0.26f * (1.0f - smoothstep(0.3f, 1.1f, to_line)));
    c = mix(c, ink, 0.34f * (1.0f - smoothstep(0.4f, 1.3f, to_fifth)));
    return mix(c, vec3(0.97f, 0.96f, 0.93f), 1.0f - smoothstep(0.7f, 1.7f, away / pixel));
})

/// From line to line, metres: round, and nine pixels at least.
inline double spacing(double metres_per_pixel) {
    for (const double round : {1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1, 0.2})
        if (round >= 9 * metres_per_pixel) return round;
    return 0.5;
}

}  // namespace pinfield::isolines
